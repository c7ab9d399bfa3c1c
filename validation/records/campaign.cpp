#include "validation/records/campaign.hpp"

#include "state/errors.hpp"
#include "validation/records/tables.hpp"

#include <boost/algorithm/string.hpp>
#include <boost/lexical_cast/try_lexical_convert.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <sys/times.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <iterator>
#include <set>
#include <sstream>
#include <stdexcept>

namespace clack::validation {

namespace {

/// A replicate's line in the file ends so: one without was cut short.
constexpr char const* line_end = " ;";

/// Where a process leaves what it measured of one state point, beside the campaign's own file.
std::filesystem::path part_of(std::filesystem::path const& whole, std::size_t const point) {
    return whole.string() + fmt::format(".{}", point);
}

/// Processor time of this program so far, and of the programs that it has run.  [s]
double processor_seconds_in_all() {
    tms used{};
    times(&used);
    auto const ticks = used.tms_utime + used.tms_stime + used.tms_cutime + used.tms_cstime;
    return static_cast<double>(ticks) / static_cast<double>(sysconf(_SC_CLK_TCK));
}

/// Two points of one text would be one: same seeds, same replicates.
void require_distinct(std::vector<Task> const& tasks) {
    std::set<std::string> texts;
    for (Task const& task : tasks) {
        if (task.state_point.find_first_of("|\n") != std::string::npos)
            throw std::invalid_argument(
                fmt::format("state point = {}: holds a | or a line end", task.state_point));
        if (!texts.insert(task.state_point).second)
            throw std::invalid_argument(fmt::format(
                "state point = {}: there are two; its text must name all that it depends on",
                task.state_point));
    }
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
      header_(fmt::format("# replicates of {}, program {}", seeded_by_, program)), share_(share),
      path_(directory / (stem + ".replicates")) {
    take_in(path_);
    if (share_.listed) return;
    if (share_.point > 0) {
        path_ = part_of(path_, static_cast<std::size_t>(share_.point));
        take_in(path_);
    }
    save();
}

void Campaign::take_in(std::filesystem::path const& path) {
    for (auto& [state_point, replicates] : recorded(path, header_))
        known_[state_point].merge(replicates);
}

/// Writes all anew, so that the next line does not run on from one cut short, and moves it into
/// place, so that an interruption here loses nothing either.
void Campaign::save() const {
    std::string text = header_ + '\n';
    for (auto const& [state_point, replicates] : known_)
        for (auto const& [number, replicate] : replicates) text += replicate.line + '\n';
    write_file(path_, text);
}

std::vector<std::vector<Measurement>> Campaign::replicates(std::vector<Task> const& tasks) {
    require_distinct(tasks);
    if (share_.listed) {
        for (Task const& task : tasks) std::cout << task.state_point << '\n';
        throw ShareDone{};
    }
    if (share_.point > 0) {
        auto const number = static_cast<std::size_t>(share_.point);
        if (number > tasks.size()) {
            std::filesystem::remove(path_);
            throw InputError(fmt::format("--point = {}: must be one of the {} that --list prints",
                                         share_.point, tasks.size()));
        }
        measured(tasks[number - 1]);
        throw ShareDone{};
    }
    for (std::size_t k = 1; k <= tasks.size(); ++k) take_in(part_of(path_, k));
    save();
    for (std::size_t k = 1; k <= tasks.size(); ++k) std::filesystem::remove(part_of(path_, k));
    std::vector<std::vector<Measurement>> all;
    for (Task task : tasks) {
        task.replicates *= times_as_many_;
        all.push_back(measured(task));
    }
    has_tasks_ = true;
    return all;
}

bool Campaign::lengthen() {
    times_as_many_ *= 2;
    return has_tasks_;
}

std::vector<Measurement> Campaign::replicates(std::string const& state_point, int const count,
                                              Measure const& measure) {
    if (share_.listed || share_.point > 0) throw ShareDone{};
    return measured({state_point, count, measure});
}

std::vector<Measurement> Campaign::measured(Task const& task) {
    auto const& [state_point, count, measure] = task;
    auto& known = known_[state_point];
    int& asked_before = asked_for_[state_point];
    int missing = 0;
    for (int number = 0; number < count; ++number) missing += !known.contains(number);
    if (missing > 0)
        std::cout << fmt::format("{}: {}: measuring {} of {} replicates\n", seeded_by_, state_point,
                                 missing, count)
                  << std::flush;
    std::vector<Measurement> all;
    for (int number = 0; number < count; ++number) {
        if (auto const found = known.find(number); found != known.end()) {
            if (number >= asked_before) seconds_recalled_ += found->second.seconds;
        } else {
            std::uint64_t const seed = seed_of(seeded_by_, state_point, number);
            double const before = processor_seconds_in_all();
            Measurement const values = measure(seed);
            double const seconds = processor_seconds_in_all() - before;
            known[number] = {values, seconds,
                             fmt::format("{}|{}|{}|{:.4f}|{}{}", state_point, number, seed, seconds,
                                         fmt::join(values, " "), line_end)};
            std::ofstream file(path_, std::ios::binary | std::ios::app);
            file << known[number].line << '\n' << std::flush;
            if (!file) throw InputError(fmt::format("{}: cannot be written", path_.string()));
        }
        all.push_back(known[number].values);
    }
    asked_before = std::max(asked_before, count);
    return all;
}

double Campaign::seconds(std::string const& state_point) const {
    double sum = 0;
    for (auto const& [number, replicate] : known_.at(state_point)) sum += replicate.seconds;
    return sum;
}

double Campaign::seconds() const { return processor_seconds_in_all() + seconds_recalled_; }

Replicates recorded(std::filesystem::path const& path, std::string const& header) {
    Replicates all;
    std::ifstream file(path, std::ios::binary);
    std::string line;
    if (!std::getline(file, line) || (!header.empty() && line != header)) return all;
    while (std::getline(file, line)) {
        std::vector<std::string> parts; // state point, number, seed, seconds, values
        boost::split(parts, line, boost::is_any_of("|"));
        int number = 0;
        Replicate replicate{{}, 0, line};
        if (parts.size() != 5 || !line.ends_with(line_end) ||
            !boost::conversion::try_lexical_convert(parts[1], number) ||
            !boost::conversion::try_lexical_convert(parts[3], replicate.seconds))
            continue;
        std::istringstream values(parts[4]);
        for (std::string value; values >> value && value != ";";)
            replicate.values.push_back(std::strtod(value.c_str(), nullptr)); // numbers or not
        all[parts[0]].try_emplace(number, replicate);
    }
    return all;
}

std::string program_hash() {
    std::ifstream file("/proc/self/exe", std::ios::binary);
    std::string const program{std::istreambuf_iterator<char>(file), {}};
    return fmt::format("{:016x}", hash_of(program));
}

} // namespace clack::validation
