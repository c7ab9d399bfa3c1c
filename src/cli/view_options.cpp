#include "cli/view_options.hpp"

#include <cstdio>
#include <map>
#include <string>

namespace clack {

namespace {

/// "1600x1200"
void read_size(std::string const& text, view::Options& options) {
    int width = 0, height = 0, end = 0;
    constexpr int most = 4096; // sampled three times as finely, still a size for any OpenGL
    bool const read = std::sscanf(text.c_str(), "%dx%d%n", &width, &height, &end) == 2 &&
                      static_cast<std::size_t>(end) == text.size();
    if (!read || width < 16 || height < 16 || width > most || height > most)
        throw CLI::ValidationError("--size", text + ": must be WIDTHxHEIGHT, each 16 to 4096");
    options.width = width;
    options.height = height;
}

/// Adds an option that is one of some words.
///   option   its name; others that it also goes by follow after commas
///   result   what the word stands for, where one is given
template <class Meaning, class Result>
CLI::Option* add_word(CLI::App& command, std::string const& option, Result& result,
                      std::map<std::string, Meaning> const& meanings, std::string const& help) {
    auto const read = [name = option.substr(0, option.find(',')), &result,
                       meanings](std::string const& word) {
        auto const found = meanings.find(word);
        if (found != meanings.end()) {
            result = found->second;
            return;
        }
        std::string words;
        for (auto const& [known, meaning] : meanings) words += (words.empty() ? "" : ", ") + known;
        throw CLI::ValidationError(name, word + ": must be one of " + words);
    };
    return command.add_option_function<std::string>(option, read, help);
}

void add_camera_options(CLI::App& command, view::Options& options) {
    using view::Background;
    using view::Colouring;
    add_word<Colouring>(
        command, "--colour,--color", options.colouring,
        {{"speed", Colouring::speed},
         {"energy", Colouring::energy},
         {"collisions", Colouring::collisions},
         {"side", Colouring::side}},
        "by speed, energy, collisions or side (the half of the cube it started in) [speed]")
        ->type_name("WHAT");
    add_word<Background>(command, "--background", options.background,
                         {{"light", Background::light}, {"dark", Background::dark}},
                         "light or dark [light; of the window: dark]")
        ->type_name("WHICH");
    command.add_option("--azimuth", options.azimuth, "where the camera stands [-60]")
        ->type_name("DEGREES");
    command.add_option("--elevation", options.elevation, "how high it stands [20]")
        ->type_name("DEGREES")
        ->check(CLI::Range(-90.0, 90.0).description(""));
    command.add_option("--zoom", options.zoom, "1 shows the whole cube")
        ->type_name("FACTOR")
        ->check(CLI::Range(0.3, 100.0).description(""));
}

void add_cut_options(CLI::App& command, view::Options& options) {
    using view::Face;
    command.add_option("--clip", options.clip, "share of the cube that is drawn [1]")
        ->type_name("SHARE")
        ->check(CLI::Range(0.0, 1.0).description(""));
    add_word<Face>(command, "--clip-from", options.clip_from,
                   {{"left", Face::left},
                    {"right", Face::right},
                    {"front", Face::front},
                    {"back", Face::back},
                    {"bottom", Face::bottom},
                    {"top", Face::top}},
                   "the face at which the rest is cut away: left, right (of x), front, back "
                   "(of y), bottom or top (of z) [front]")
        ->type_name("FACE");
}

void add_picture_options(CLI::App& command, view::Options& options) {
    command.add_option("--screenshot", options.screenshot, "picture to draw, without a display")
        ->type_name("OUT.png");
    command.add_option("--movie", options.movie, "movie to draw, without a display")
        ->type_name("OUT.mp4");
    command
        .add_option(
            "--time", options.times,
            "of the picture, or the movie's start; several times: pictures side by side, or one "
            "below the other if they are three times as wide as high [0; of a file: its last]")
        ->type_name("T[,T...]")
        ->delimiter(',');
    command
        .add_option_function<std::string>(
            "--size", [&](std::string const& text) { read_size(text, options); },
            "of the picture or the window [1000x750]")
        ->type_name("WIDTHxHEIGHT");
    command.add_option("--duration", options.duration, "of the movie in seconds [10]")
        ->type_name("S")
        ->check(CLI::Range(0.01, 36000.0).description(""));
    command.add_option("--fps", options.frame_rate, "frames in a second of the movie [60]")
        ->type_name("N")
        ->check(CLI::Range(1, 240).description(""));
    command.add_option("--speed", options.speed, "simulated time in a second [1]")
        ->type_name("FACTOR")
        ->check(CLI::Range(1e-9, 1e9).description(""));
}

} // namespace

void add_view_options(CLI::App& command, view::Options& options) {
    add_picture_options(command, options);
    add_camera_options(command, options);
    add_cut_options(command, options);
    command
        .add_option("--visit", options.visit,
                    "file of what to do in the window, one command a line: for demonstrations")
        ->type_name("FILE");
}

} // namespace clack
