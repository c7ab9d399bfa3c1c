#include "validation/harness/campaign.hpp"

#include "state/errors.hpp"
#include "validation/harness/processor_time.hpp"
#include "validation/harness/seeds.hpp"
#include "validation/harness/write_file.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <charconv>
#include <fstream>
#include <iostream>
#include <iterator>
#include <optional>
#include <sstream>

namespace clack::validation {

namespace {

/// The end of a line that was written whole.
constexpr char line_end = ';';

struct Line {
    std::string state_point;
    int replicate;
    double seconds;
    Measurement values;
};

std::string written(Line const& line, std::uint64_t const seed) {
    return fmt::format("{}|{}|{}|{:.4f}|{} {}", line.state_point, line.replicate, seed,
                       line.seconds, fmt::join(line.values, " "), line_end);
}

template <class Number> bool parse(std::string const& text, Number& number) {
    char const* const end = text.data() + text.size();
    auto const [stopped, failure] = std::from_chars(text.data(), end, number);
    return failure == std::errc() && stopped == end;
}

std::optional<Line> read(std::string const& text) {
    Line line;
    std::istringstream stream(text);
    std::string replicate, seed, seconds, values;
    if (text.empty() || text.back() != line_end || !std::getline(stream, line.state_point, '|') ||
        !std::getline(stream, replicate, '|') || !std::getline(stream, seed, '|') ||
        !std::getline(stream, seconds, '|') || !std::getline(stream, values, line_end))
        return std::nullopt;
    if (!parse(replicate, line.replicate) || !parse(seconds, line.seconds)) return std::nullopt;
    std::istringstream numbers(values);
    for (std::string number; numbers >> number;)
        if (!parse(number, line.values.emplace_back())) return std::nullopt;
    return line;
}

std::string contents(std::filesystem::path const& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

} // namespace

Campaign::Campaign(std::string stem, std::filesystem::path const& directory,
                   std::string const& program, int const seed_set)
    : stem_(std::move(stem)),
      seeded_by_(seed_set == 0 ? stem_ : fmt::format("{}#{}", stem_, seed_set)),
      path_(directory / (stem_ + ".replicates")) {
    recall(fmt::format("# replicates of {}, program {}", seeded_by_, program));
}

void Campaign::recall(std::string const& header) {
    std::istringstream file(contents(path_));
    std::string kept = header + '\n';
    std::string text;
    if (std::getline(file, text) && text == header) {
        while (std::getline(file, text)) {
            if (auto const line = read(text)) {
                known_[{line->state_point, line->replicate}] = {line->values, line->seconds};
                kept += text + '\n';
            }
        }
    }
    // Written anew, so that the next line does not run on from one cut short, and moved into place,
    // so that an interruption here loses nothing either.
    write_file(path_, kept);
}

void Campaign::append(std::string const& line) {
    std::ofstream file(path_, std::ios::binary | std::ios::app);
    file << line << '\n' << std::flush;
    if (!file) throw InputError(fmt::format("{}: cannot be written", path_.string()));
}

std::vector<Measurement> Campaign::replicates(std::string const& state_point, int const count,
                                              Measure const& measure) {
    asked_for_.push_back(state_point);
    int missing = 0;
    for (int replicate = 0; replicate < count; ++replicate)
        missing += !known_.contains({state_point, replicate});
    if (missing > 0) {
        std::cout << fmt::format("{}: {}: measuring {} of {} replicates\n", stem_, state_point,
                                 missing, count)
                  << std::flush;
    }

    std::vector<Measurement> all;
    for (int replicate = 0; replicate < count; ++replicate) {
        auto const found = known_.find({state_point, replicate});
        if (found != known_.end()) {
            all.push_back(found->second.values);
            seconds_recalled_ += found->second.seconds;
            continue;
        }
        std::uint64_t const seed = seed_of(seeded_by_, state_point, replicate);
        double const before = processor_seconds_in_all();
        Measurement const values = measure(seed);
        double const seconds = processor_seconds_in_all() - before;
        append(written({state_point, replicate, seconds, values}, seed));
        known_[{state_point, replicate}] = {values, seconds};
        ++measured_count_;
        all.push_back(values);
    }
    return all;
}

double Campaign::seconds(std::string const& state_point) const {
    double sum = 0;
    for (auto const& [key, replicate] : known_)
        if (key.first == state_point) sum += replicate.seconds;
    return sum;
}

std::string program_hash() { return fmt::format("{:016x}", hash_of(contents("/proc/self/exe"))); }

} // namespace clack::validation
