#include "reference/lammps_files.hpp"

#include "state/errors.hpp"

#include <fmt/format.h>

#include <fstream>
#include <numbers>
#include <set>
#include <sstream>

namespace clack::reference {

namespace {

/// The lines of a dump, one by one, with a place for messages.
class DumpLines {
public:
    explicit DumpLines(std::filesystem::path const& path) : path_(path), file_(path) {
        if (!file_) throw InputError(path.string() + ": cannot be read");
    }

    bool at_end() { return file_.peek() == std::ifstream::traits_type::eof(); }

    std::string line() {
        std::string text;
        ++number_;
        if (!std::getline(file_, text) || file_.eof()) fail("the dump is cut short");
        return text;
    }

    /// The rest of a line that begins so.
    std::string after(std::string const& head) {
        std::string const text = line();
        if (!text.starts_with(head)) fail(fmt::format("not \"{}\" but \"{}\"", head, text));
        return text.substr(head.size());
    }

    std::int64_t integer() {
        std::string const text = line();
        try {
            return std::stoll(text);
        } catch (std::logic_error const&) {
            fail(fmt::format("\"{}\" is no whole number", text));
        }
    }

    void numbers(Eigen::MatrixXd::RowXpr row) {
        std::istringstream words(line());
        for (Eigen::Index k = 0; k < row.size(); ++k) {
            std::string word;
            std::size_t read = 0;
            try {
                if (words >> word) row[k] = std::stod(word, &read);
            } catch (std::logic_error const&) {
                read = 0;
            }
            if (word.empty() || read != word.size())
                fail(fmt::format("\"{}\" stands for number {} of {}", word, k + 1, row.size()));
        }
    }

    [[noreturn]] void fail(std::string const& what) const {
        throw InputError(fmt::format("{}:{}: {}", path_.string(), number_, what));
    }

private:
    std::filesystem::path path_;
    std::ifstream file_;
    int number_ = 0;
};

std::vector<std::string> words_of(std::string const& text) {
    std::vector<std::string> words;
    std::istringstream stream(text);
    for (std::string word; stream >> word;) words.push_back(word);
    return words;
}

DumpFrame read_frame(DumpLines& lines) {
    DumpFrame frame;
    lines.after("ITEM: TIMESTEP");
    frame.step = lines.integer();
    std::string const of = lines.after("ITEM: NUMBER OF "); // ATOMS or ENTRIES
    std::int64_t const count = lines.integer();
    lines.after("ITEM: BOX BOUNDS");
    for (int d = 0; d < 3; ++d) lines.line();
    frame.columns = words_of(lines.after("ITEM: " + of + " "));
    frame.rows.resize(count, static_cast<Eigen::Index>(frame.columns.size()));
    for (Eigen::Index row = 0; row < frame.rows.rows(); ++row) lines.numbers(frame.rows.row(row));
    return frame;
}

} // namespace

void write_lammps_data(std::filesystem::path const& path, System const& system,
                       Start const& start) {
    double const diameter = system.diameter;
    double const density = 6 * system.mass / (std::numbers::pi * diameter * diameter * diameter);
    std::string text = fmt::format("balls\n\n{} atoms\n1 atom types\n", system.count);
    for (char const axis : {'x', 'y', 'z'})
        text += fmt::format("0 {:.17g} {}lo {}hi\n", system.side, axis, axis);
    text += "\nAtoms # sphere\n\n";
    for (Eigen::Index i = 0; i < system.count; ++i) {
        auto const place = start.positions.col(i);
        text += fmt::format("{} 1 {:.17g} {:.17g} {:.17g} {:.17g} {:.17g}\n", i + 1, diameter,
                            density, place[0], place[1], place[2]);
    }
    text += "\nVelocities\n\n";
    for (Eigen::Index i = 0; i < system.count; ++i) {
        auto const velocity = start.velocities.col(i);
        text += fmt::format("{} {:.17g} {:.17g} {:.17g} 0 0 0\n", i + 1, velocity[0], velocity[1],
                            velocity[2]);
    }
    std::ofstream file(path);
    file << text << std::flush;
    if (!file) throw InputError(path.string() + ": cannot be written; is the disk full?");
}

Eigen::VectorXd DumpFrame::column(std::string const& name) const {
    for (std::size_t k = 0; k < columns.size(); ++k)
        if (columns[k] == name) return rows.col(static_cast<Eigen::Index>(k));
    throw InputError(fmt::format("step {} of the dump has no column {}", step, name));
}

std::vector<DumpFrame> read_lammps_dump(std::filesystem::path const& path) {
    std::vector<DumpFrame> frames;
    DumpLines lines(path);
    while (!lines.at_end()) frames.push_back(read_frame(lines));
    return frames;
}

Start balls_of(DumpFrame const& frame) {
    Eigen::VectorXd const ids = frame.column("id");
    for (Eigen::Index i = 0; i < ids.size(); ++i) {
        if (ids[i] != static_cast<double>(i + 1)) {
            throw InputError(fmt::format("step {} of the dump: atom {} stands where {} should",
                                         frame.step, ids[i], i + 1));
        }
    }
    Start balls{Eigen::Matrix3Xd(3, ids.size()), Eigen::Matrix3Xd(3, ids.size())};
    Eigen::Index d = 0;
    for (std::string const axis : {"x", "y", "z"}) {
        balls.positions.row(d) = frame.column(axis).transpose();
        balls.velocities.row(d) = frame.column("v" + axis).transpose();
        ++d;
    }
    return balls;
}

std::vector<SeenCollision> collisions_seen(std::vector<DumpFrame> const& frames) {
    std::vector<SeenCollision> seen;
    std::set<std::pair<std::int64_t, std::int64_t>> before;
    for (DumpFrame const& frame : frames) {
        std::set<std::pair<std::int64_t, std::int64_t>> now;
        for (Eigen::Index k = 0; k < frame.rows.rows(); ++k) {
            auto const a = static_cast<std::int64_t>(frame.rows(k, 0)) - 1;
            auto const b = static_cast<std::int64_t>(frame.rows(k, 1)) - 1;
            now.emplace(std::min(a, b), std::max(a, b));
        }
        for (auto const& pair : now)
            if (!before.contains(pair)) seen.push_back({frame.step, pair.first, pair.second});
        before = std::move(now);
    }
    return seen;
}

std::vector<double> read_lammps_means(std::filesystem::path const& path) {
    std::ifstream file(path);
    std::vector<double> last;
    for (std::string line; std::getline(file, line);) {
        if (line.empty() || line.front() == '#') continue;
        std::istringstream words(line);
        std::int64_t step = 0;
        std::vector<double> row;
        words >> step;
        for (double value = 0; words >> value;) row.push_back(value);
        last = std::move(row);
    }
    if (last.empty()) throw InputError(path.string() + ": has no row of means");
    return last;
}

} // namespace clack::reference
