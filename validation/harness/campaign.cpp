#include "validation/harness/campaign.hpp"

#include "state/errors.hpp"
#include "validation/harness/tables.hpp"

#include <boost/algorithm/string.hpp>
#include <boost/lexical_cast/try_lexical_convert.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <sys/resource.h>

#include <cstdlib>
#include <fstream>
#include <iostream>
#include <iterator>
#include <optional>
#include <sstream>

namespace clack::validation {

namespace {

constexpr char const* line_end = " ;"; // of a line that was written whole

struct Line {
    std::string state_point;
    int number = 0;
    double seconds = 0;
    Measurement values = {};
};

/// The line of one replicate; nothing where it was not written whole.
std::optional<Line> read(std::string const& text) {
    std::vector<std::string> parts; // state point, number, seed, seconds, values
    boost::split(parts, text, boost::is_any_of("|"));
    Line line{parts[0]};
    if (parts.size() != 5 || !text.ends_with(line_end) ||
        !boost::conversion::try_lexical_convert(parts[1], line.number) ||
        !boost::conversion::try_lexical_convert(parts[3], line.seconds))
        return std::nullopt;
    std::istringstream values(parts[4]);
    for (std::string value; values >> value && value != ";";)
        line.values.push_back(std::strtod(value.c_str(), nullptr)); // numbers or not
    return line;
}

std::string contents(std::filesystem::path const& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

/// Where a process leaves what it measured of one state point, beside the campaign's own file.
std::filesystem::path part_of(std::filesystem::path const& whole, std::size_t const point) {
    return whole.string() + fmt::format(".{}", point);
}

/// Processor time of this program so far, and of the programs that it has run.  [s]
double processor_seconds_in_all() {
    double seconds = 0;
    for (auto const who : {RUSAGE_SELF, RUSAGE_CHILDREN}) {
        rusage used{};
        getrusage(who, &used);
        for (timeval const& part : {used.ru_utime, used.ru_stime})
            seconds += static_cast<double>(part.tv_sec) + 1e-6 * static_cast<double>(part.tv_usec);
    }
    return seconds;
}

} // namespace

std::uint64_t hash_of(std::string_view const text) {
    std::uint64_t bits = 0xcbf29ce484222325u;
    for (char const character : text)
        bits = (bits ^ static_cast<unsigned char>(character)) * 0x100000001b3u;
    bits = (bits ^ (bits >> 30)) * 0xbf58476d1ce4e5b9u;
    bits = (bits ^ (bits >> 27)) * 0x94d049bb133111ebu;
    return bits ^ (bits >> 31);
}

std::uint64_t seed_of(std::string_view const experiment, std::string_view const state_point,
                      int const replicate) {
    return hash_of(fmt::format("{}|{}|{}", experiment, state_point, replicate)) >> 1;
}

Campaign::Campaign(std::string const& stem, std::filesystem::path const& directory,
                   std::string const& program, int const seed_set, Share const share)
    : seeded_by_(seed_set == 0 ? stem : fmt::format("{}#{}", stem, seed_set)),
      header_(fmt::format("# replicates of {}, program {}\n", seeded_by_, program)), share_(share),
      path_(directory / (stem + ".replicates")) {
    std::string text = recall(path_);
    if (share_.kind == Share::Kind::list) return;
    if (share_.kind == Share::Kind::one_point) {
        path_ = part_of(path_, static_cast<std::size_t>(share_.point));
        text = recall(path_);
    }
    // Written anew, so that the next line does not run on from one cut short, and moved into place,
    // so that an interruption here loses nothing either.
    write_file(path_, header_ + text);
}

/// Takes in the whole lines of a file that belongs to this campaign, and returns them.
std::string Campaign::recall(std::filesystem::path const& path) {
    std::istringstream file(contents(path));
    std::string kept, text;
    if (!std::getline(file, text) || text + '\n' != header_) return "";
    while (std::getline(file, text)) {
        auto const line = read(text);
        if (line && known_[line->state_point]
                        .try_emplace(line->number, Replicate{line->values, line->seconds})
                        .second)
            kept += text + '\n';
    }
    return kept;
}

/// Takes in what processes of one state point each have measured.
void Campaign::gather(std::size_t const task_count) {
    std::string text = contents(path_);
    for (std::size_t k = 1; k <= task_count; ++k) text += recall(part_of(path_, k));
    write_file(path_, text);
    for (std::size_t k = 1; k <= task_count; ++k) std::filesystem::remove(part_of(path_, k));
}

std::vector<std::vector<Measurement>> Campaign::replicates(std::vector<Task> const& tasks) {
    if (share_.kind == Share::Kind::list) {
        for (Task const& task : tasks) std::cout << task.state_point << '\n';
        throw ShareDone{};
    }
    if (share_.kind == Share::Kind::one_point) {
        auto const number = static_cast<std::size_t>(share_.point);
        if (number < 1 || number > tasks.size())
            throw InputError(fmt::format("--point = {}: must be one of the {} that --list prints",
                                         share_.point, tasks.size()));
        measured(tasks[number - 1]);
        throw ShareDone{};
    }
    gather(tasks.size());
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
    auto& known = known_[state_point];
    ++points_asked_for_;
    int missing = 0;
    for (int number = 0; number < count; ++number) missing += !known.contains(number);
    if (missing > 0)
        std::cout << fmt::format("{}: {}: measuring {} of {} replicates\n", seeded_by_, state_point,
                                 missing, count)
                  << std::flush;
    std::vector<Measurement> all;
    for (int number = 0; number < count; ++number) {
        if (auto const found = known.find(number); found != known.end()) {
            seconds_recalled_ += found->second.seconds;
        } else {
            std::uint64_t const seed = seed_of(seeded_by_, state_point, number);
            double const before = processor_seconds_in_all();
            Measurement const values = measure(seed);
            double const seconds = processor_seconds_in_all() - before;
            std::ofstream file(path_, std::ios::binary | std::ios::app);
            file << fmt::format("{}|{}|{}|{:.4f}|{}{}\n", state_point, number, seed, seconds,
                                fmt::join(values, " "), line_end)
                 << std::flush;
            if (!file) throw InputError(fmt::format("{}: cannot be written", path_.string()));
            known[number] = {values, seconds};
        }
        all.push_back(known[number].values);
    }
    return all;
}

double Campaign::seconds(std::string const& state_point) const {
    double sum = 0;
    for (auto const& [number, replicate] : known_.at(state_point)) sum += replicate.seconds;
    return sum;
}

double Campaign::seconds() const { return processor_seconds_in_all() + seconds_recalled_; }

std::map<std::string, std::vector<Measurement>> recorded(std::filesystem::path const& path) {
    std::map<std::string, std::map<int, Measurement>> in_order;
    std::istringstream file(contents(path));
    for (std::string text; std::getline(file, text);)
        if (auto const line = read(text)) in_order[line->state_point][line->number] = line->values;
    std::map<std::string, std::vector<Measurement>> all;
    for (auto const& [state_point, replicates] : in_order)
        for (auto const& [number, values] : replicates) all[state_point].push_back(values);
    return all;
}

std::string program_hash() { return fmt::format("{:016x}", hash_of(contents("/proc/self/exe"))); }

} // namespace clack::validation
