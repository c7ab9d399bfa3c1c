#include "view/visit.hpp"

#include "state/errors.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <cstdio>
#include <fstream>
#include <map>
#include <sstream>

namespace clack::view {

namespace {

/// The commands and how many words follow each.
std::map<std::string, std::size_t> const& known_commands() {
    static std::map<std::string, std::size_t> const known{
        {"key", 1},  {"click", 2}, {"drag", 2}, {"scroll", 1}, {"wait", 1},  {"until", 1},
        {"save", 1}, {"print", 0}, {"seek", 1}, {"choose", 2}, {"start", 0}, {"pick", 1}};
    return known;
}

float number(std::string const& word) { return std::stof(word); }

std::string state_of(Session const& session, Visited& window) {
    Shown const& shown = *session.shown;
    auto const& next = shown.frame.next;
    auto const& tallies = shown.frame.sample.tallies;
    nlohmann::ordered_json state{
        {"time", shown.frame.snapshot.time},
        {"playing", shown.playing == Playing::yes},
        {"speed", shown.speed},
        {"true_speed", shown.rates.speed},
        {"balls", shown.frame.system.count},
        {"packing_fraction", shown.frame.system.packing_fraction()},
        {"collisions", shown.frame.total_collisions},
        {"ball_collisions", tallies.ball_collisions},
        {"first_x", shown.frame.snapshot.positions(0, 0)},
        {"traced", shown.frame.traced},
        {"bends", shown.frame.path.size()},
        {"next_time", next ? nlohmann::ordered_json(next->time) : nullptr},
        {"last_time", std::isfinite(shown.last_time) ? shown.last_time : -1},
        {"engine_share", shown.rates.engine_share},
        {"drawing_seconds", window.drawing_seconds()},
        {"deafness", window.longest_deafness()},
        {"answer", window.longest_answer()},
        {"description", shown.description},
        {"remark", shown.remark},
        {"unforetold", shown.unforetold},
        {"message", shown.message}};
    return state.dump();
}

} // namespace

Visit::Visit(std::string const& path) {
    std::ifstream file(path);
    if (!file) throw InputError(path + ": no such file; name a visit");
    std::string line;
    for (int number_of_line = 1; std::getline(file, line); ++number_of_line) {
        std::istringstream stream(line.substr(0, line.find('#')));
        Command command;
        if (!(stream >> command.name)) continue;
        for (std::string word; stream >> word;) command.words.push_back(word);
        auto const refuse = [&](std::string const& why) {
            throw InputError(fmt::format("{}:{}: {}: {}", path, number_of_line, line, why));
        };
        auto const known = known_commands().find(command.name);
        if (known == known_commands().end() || known->second != command.words.size())
            refuse("no such command, or with another number of words");
        if (command.name == "key" && !key_of(command.words[0]))
            refuse("no such key; the list of keys names them");
        commands_.push_back(command);
    }
}

bool Visit::is_done_waiting(Session const& session, Visited const& window) const {
    if (!window.is_up_to_date() || !session.player.is_settled(*session.shown)) return false;
    if (Clock::now() < wait_until_) return false;
    return session.shown->frame.snapshot.time >= wait_for_time_;
}

void Visit::go_on(Session& session, Visited& window) {
    if (!is_done_waiting(session, window)) return;
    wait_for_time_ = -1;
    if (next_ == commands_.size()) {
        session.closing = true;
        return;
    }
    perform(commands_[next_++], session, window);
}

void Visit::choose(Command const& command, Session& session) const {
    auto const& what = command.words[0];
    if (what == "balls") session.choice.count = static_cast<int>(number(command.words[1]));
    if (what == "packing_fraction") session.choice.packing_fraction = number(command.words[1]);
    if (what == "seed") session.choice.seed = static_cast<int>(number(command.words[1]));
    if (what == "method") session.choice.method = command.words[1];
}

void Visit::perform(Command const& command, Session& session, Visited& window) {
    auto const& [name, words] = command;
    if (name == "key") window.press(*key_of(words[0]));
    if (name == "click") window.click(number(words[0]), number(words[1]));
    if (name == "drag") window.drag(number(words[0]), number(words[1]));
    if (name == "scroll") window.scroll(number(words[0]));
    if (name == "until") wait_for_time_ = static_cast<double>(number(words[0]));
    if (name == "save") window.save(words[0]);
    if (name == "seek") session.player.seek(static_cast<double>(number(words[0])));
    if (name == "pick") session.player.trace(std::stoll(words[0]));
    if (name == "choose") choose(command, session);
    if (name == "start") session.restart();
    if (name == "wait")
        wait_until_ =
            Clock::now() + std::chrono::milliseconds(std::lround(1000 * number(words[0])));
    if (name == "print") {
        fmt::print("{}\n", state_of(session, window));
        std::fflush(stdout);
    }
}

} // namespace clack::view
