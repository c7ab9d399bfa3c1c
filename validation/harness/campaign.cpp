#include "validation/harness/campaign.hpp"

#include "state/errors.hpp"
#include "validation/harness/processor_time.hpp"
#include "validation/harness/seeds.hpp"
#include "validation/harness/write_file.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
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

/// Files that processes of one state point each have left beside the campaign's own.
std::vector<std::filesystem::path> parts_of(std::filesystem::path const& whole) {
    std::vector<std::filesystem::path> parts;
    std::string const start = whole.filename().string() + '.';
    std::error_code none; // a folder that is not there has none
    for (auto const& entry : std::filesystem::directory_iterator(whole.parent_path(), none))
        if (entry.path().filename().string().starts_with(start)) parts.push_back(entry.path());
    std::sort(parts.begin(), parts.end());
    return parts;
}

std::string contents(std::filesystem::path const& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

} // namespace

Campaign::Campaign(std::string stem, std::filesystem::path const& directory,
                   std::string const& program, int const seed_set, Share const share)
    : stem_(std::move(stem)),
      seeded_by_(seed_set == 0 ? stem_ : fmt::format("{}#{}", stem_, seed_set)), share_(share),
      path_(directory / (stem_ + ".replicates")) {
    std::string const header = fmt::format("# replicates of {}, program {}\n", seeded_by_, program);
    std::string const whole = header + recall(path_, header);
    // Files are written anew, so that the next line does not run on from one cut short, and moved
    // into place, so that an interruption here loses nothing either.
    if (share_.kind == Share::Kind::one_point) {
        path_ += fmt::format(".{}", share_.point);
        write_file(path_, header + recall(path_, header));
    } else if (share_.kind == Share::Kind::all) {
        auto const parts = parts_of(path_);
        std::string gathered = whole;
        for (auto const& part : parts) gathered += recall(part, header);
        write_file(path_, gathered);
        for (auto const& part : parts) std::filesystem::remove(part);
    }
}

/// Takes in the whole lines of a file that belongs to this campaign, and returns them.
std::string Campaign::recall(std::filesystem::path const& path, std::string const& header) {
    std::istringstream file(contents(path));
    std::string kept, text;
    if (!std::getline(file, text) || text + '\n' != header) return "";
    while (std::getline(file, text)) {
        auto const line = read(text);
        if (!line) continue;
        auto const [place, is_new] = known_.try_emplace({line->state_point, line->replicate},
                                                        Replicate{line->values, line->seconds});
        if (is_new) kept += text + '\n';
    }
    return kept;
}

void Campaign::append(std::string const& line) {
    std::ofstream file(path_, std::ios::binary | std::ios::app);
    file << line << '\n' << std::flush;
    if (!file) throw InputError(fmt::format("{}: cannot be written", path_.string()));
}

std::vector<std::vector<Measurement>> Campaign::replicates(std::vector<Task> const& tasks) {
    auto const number = static_cast<std::size_t>(share_.point);
    if (share_.kind == Share::Kind::list) {
        for (Task const& task : tasks) std::cout << task.state_point << '\n';
        throw ShareDone{};
    }
    if (share_.kind == Share::Kind::one_point) {
        if (number < 1 || number > tasks.size())
            throw InputError(fmt::format("--point = {}: must be one of the {} that --list prints",
                                         number, tasks.size()));
        measured(tasks[number - 1]);
        throw ShareDone{};
    }
    std::vector<std::vector<Measurement>> all;
    for (Task const& task : tasks) all.push_back(measured(task));
    return all;
}

std::vector<Measurement> Campaign::replicates(std::string const& state_point, int const count,
                                              Measure const& measure) {
    if (share_.kind != Share::Kind::all) throw ShareDone{};
    return measured({state_point, count, measure});
}

std::vector<Measurement> Campaign::measured(Task const& task) {
    auto const& [state_point, count, measure] = task;
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

Estimate mean_of(std::vector<Measurement> const& replicates, std::size_t const place) {
    return mean_of(replicates, [=](Measurement const& values) { return values.at(place); });
}

std::map<std::string, std::vector<Measurement>> recorded(std::filesystem::path const& path) {
    std::map<std::pair<std::string, int>, Measurement> in_order;
    std::istringstream file(contents(path));
    for (std::string text; std::getline(file, text);)
        if (auto const line = read(text))
            in_order[{line->state_point, line->replicate}] = line->values;
    std::map<std::string, std::vector<Measurement>> all;
    for (auto const& [key, values] : in_order) all[key.first].push_back(values);
    return all;
}

std::string program_hash() { return fmt::format("{:016x}", hash_of(contents("/proc/self/exe"))); }

} // namespace clack::validation
