// Pictures and movies without a display, as users make them, judged by their pixels.

#include "tests/cli/program.hpp"

#include "state/errors.hpp"
#include "view/offscreen.hpp"

#include <boost/test/unit_test.hpp>

#include <png.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

using namespace clack;
using namespace clack::test;
using namespace clack::view;

namespace {

Folder const folder;

/// Balls at rest but one, far from each other.
std::string scene_of(std::string const& places, std::string const& velocities, int count) {
    return folder.write("scene.toml", "[container]\nboundary = \"walls\"\nside = 10.0\n[balls]\n"
                                      "count = " +
                                          std::to_string(count) +
                                          "\narrangement = \"explicit\"\npositions = [" + places +
                                          "]\n[velocities]\ndistribution = \"explicit\"\n"
                                          "velocities = [" +
                                          velocities +
                                          "]\n[run]\ntime = 4.0\n[output]\nframe_interval = 0.5\n"
                                          "events = true\n");
}

std::string two_balls() {
    return scene_of("[2.0, 5.0, 5.0], [8.0, 5.0, 5.0]", "[1.0, 0.0, 0.0], [0.0, 0.0, 0.0]", 2);
}

Pixels read_png(std::string const& path) {
    png_image image{};
    image.version = PNG_IMAGE_VERSION;
    BOOST_REQUIRE(png_image_begin_read_from_file(&image, path.c_str()));
    image.format = PNG_FORMAT_RGB;
    Pixels pixels{{static_cast<int>(image.width), static_cast<int>(image.height)}, {}};
    pixels.rgb.resize(PNG_IMAGE_SIZE(image));
    png_image_finish_read(&image, nullptr, pixels.rgb.data(), 0, nullptr);
    return pixels;
}

/// Connected patches of colour, grey being the cube and the background.
struct Patch {
    int pixels = 0;
    double x = 0, y = 0; // of its centre
};

bool is_coloured(Pixels const& pixels, int index) {
    auto const* const c = &pixels.rgb[3 * static_cast<std::size_t>(index)];
    return std::max({c[0], c[1], c[2]}) - std::min({c[0], c[1], c[2]}) > 24;
}

Patch flood(Pixels const& pixels, int start, std::vector<char>& seen) {
    Patch patch;
    int const width = pixels.size.width, all = width * pixels.size.height;
    std::vector<int> open{start};
    seen[static_cast<std::size_t>(start)] = 1;
    while (!open.empty()) {
        int const at = open.back();
        open.pop_back();
        ++patch.pixels;
        patch.x += at % width;
        patch.y += at / width;
        for (int const next : {at - 1, at + 1, at - width, at + width}) {
            if (next < 0 || next >= all || seen[static_cast<std::size_t>(next)]) continue;
            if (!is_coloured(pixels, next)) continue;
            seen[static_cast<std::size_t>(next)] = 1;
            open.push_back(next);
        }
    }
    patch.x /= patch.pixels;
    patch.y /= patch.pixels;
    return patch;
}

std::vector<Patch> patches_of(Pixels const& pixels) {
    std::vector<Patch> patches;
    std::vector<char> seen(pixels.rgb.size() / 3, 0);
    for (int index = 0; index < static_cast<int>(seen.size()); ++index) {
        if (seen[static_cast<std::size_t>(index)] || !is_coloured(pixels, index)) continue;
        auto const patch = flood(pixels, index, seen);
        constexpr int specks = 12; // where an edge of the cube cuts off a sliver
        if (patch.pixels > specks) patches.push_back(patch);
    }
    return patches;
}

int dark_pixels(Pixels const& pixels) {
    int count = 0;
    for (std::size_t i = 0; i < pixels.rgb.size(); i += 3)
        count += pixels.rgb[i] < 215 && !is_coloured(pixels, static_cast<int>(i / 3));
    return count;
}

Pixels shot(std::vector<std::string> const& more, std::string const& path) {
    std::vector<std::string> words{"view", path, "--screenshot", folder.file("shot.png")};
    words.insert(words.end(), more.begin(), more.end());
    if (std::find(more.begin(), more.end(), "--size") == more.end())
        words.insert(words.end(), {"--size", "320x240"});
    auto const outcome = run_clack(words);
    BOOST_REQUIRE_MESSAGE(outcome.code == 0, outcome.err);
    return read_png(folder.file("shot.png"));
}

/// What a movie is: its code, width, height, rate, and how many frames can be read from it.
std::string probed(std::string const& movie) {
    auto const out = folder.file("probe.txt");
    auto const command = "ffprobe -v error -count_frames -of csv=p=0 -show_entries stream="
                         "codec_name,width,height,r_frame_rate,nb_read_frames '" +
                         movie + "' > '" + out + "'";
    BOOST_REQUIRE(std::system(command.c_str()) == 0);
    return text_of(out);
}

} // namespace

BOOST_AUTO_TEST_CASE(each_ball_is_a_patch_of_its_colour) {
    auto const path = two_balls();
    BOOST_TEST(patches_of(shot({}, path)).size() == 2u);
    auto const front = shot({"--azimuth", "-90", "--elevation", "0", "--colour", "side"}, path);
    auto const patches = patches_of(front);
    BOOST_REQUIRE(patches.size() == 2u);
    // Seen from the front the balls lie left and right of the middle, half way up, equally large.
    BOOST_TEST(std::abs(patches[0].x + patches[1].x - 319) < 3);
    BOOST_TEST(std::abs(patches[0].y - 119.5) < 2);
    BOOST_TEST(std::abs(patches[0].pixels - patches[1].pixels) < 0.1 * patches[0].pixels);
}

BOOST_AUTO_TEST_CASE(the_cube_is_drawn_and_one_ball_too) {
    auto const path = scene_of("[5.0, 5.0, 5.0]", "[1.0, 0.0, 0.0]", 1);
    auto const picture = shot({}, path);
    BOOST_TEST(patches_of(picture).size() == 1u);
    BOOST_TEST(dark_pixels(picture) > 600); // twelve edges of some hundred pixels each
    BOOST_TEST(dark_pixels(picture) < 6000);
}

BOOST_AUTO_TEST_CASE(a_picture_shows_its_time) {
    auto const path = two_balls();
    auto const x_at = [&](std::string const& time) {
        auto const all =
            patches_of(shot({"--azimuth", "-90", "--elevation", "0", "--time", time}, path));
        BOOST_REQUIRE(all.size() == 2u);
        return std::min(all[0].x, all[1].x);
    };
    double const pixels_per_length = (x_at("2.0") - x_at("0")) / 2;
    BOOST_TEST(pixels_per_length > 10);
    BOOST_TEST(std::abs(x_at("1.25") - x_at("0") - 1.25 * pixels_per_length) < 1);
}

BOOST_AUTO_TEST_CASE(the_same_scene_gives_the_same_pixels_live_and_replayed) {
    auto const path = two_balls();
    auto const first = shot({"--time", "1.3"}, path);
    BOOST_TEST((shot({"--time", "1.3"}, path).rgb == first.rgb));
    BOOST_REQUIRE(run_clack({"run", path, "-o", folder.file("run.h5"), "--quiet"}).code == 0);
    BOOST_TEST((shot({"--time", "1.3"}, folder.file("run.h5")).rgb == first.rgb));
}

BOOST_AUTO_TEST_CASE(a_file_without_collisions_shows_its_frames_and_says_which) {
    auto const path = two_balls();
    auto const file = folder.file("frames.h5");
    BOOST_REQUIRE(
        run_clack({"run", path, "-o", file, "--quiet", "--set", "output.events=false"}).code == 0);
    auto const between = run_clack({"view", file, "--screenshot", folder.file("between.png"),
                                    "--time", "1.3", "--size", "320x240"});
    BOOST_TEST(between.code == 0);
    BOOST_TEST(between.err_is_one_line());
    BOOST_TEST(between.err.find("for time 1.3 its frame of time 1 is drawn") != std::string::npos);
    BOOST_TEST((read_png(folder.file("between.png")).rgb == shot({"--time", "1"}, path).rgb));
    BOOST_TEST(run_clack({"view", file, "--screenshot", folder.file("at.png"), "--time", "1.5"})
                   .err.empty());
}

BOOST_AUTO_TEST_CASE(times_stand_side_by_side_and_strips_one_below_the_other) {
    auto const picture = shot({"--time", "0,1,2"}, two_balls());
    BOOST_TEST(picture.size.width == 960);
    BOOST_TEST(picture.size.height == 240);
    BOOST_TEST(patches_of(picture).size() == 6u);
    auto const strips = shot({"--time", "0,1,2", "--size", "320x100"}, two_balls());
    BOOST_TEST(strips.size.width == 320);
    BOOST_TEST(strips.size.height == 300);
    BOOST_TEST(patches_of(strips).size() == 6u);
}

BOOST_AUTO_TEST_CASE(clipping_hides_the_balls_in_front) {
    auto const path =
        scene_of("[5.0, 1.0, 5.0], [2.0, 8.0, 5.0]", "[1.0, 0.0, 0.0], [0.0, 0.0, 0.0]", 2);
    std::vector<std::string> words{"--azimuth", "-90", "--elevation", "0"};
    BOOST_TEST(patches_of(shot(words, path)).size() == 2u);
    constexpr int middle = 120 * 320 + 160, aside = 120 * 320 + 105; // where the two are seen
    BOOST_TEST(is_coloured(shot(words, path), aside));
    BOOST_TEST(is_coloured(shot(words, path), middle));
    words.insert(words.end(), {"--clip", "0.5"});
    BOOST_TEST(!is_coloured(shot(words, path), middle));
    BOOST_TEST(patches_of(shot(words, path)).size() == 2u); // the farther ball, the plane's frame
    words.insert(words.end(), {"--clip-from", "back"});
    BOOST_TEST(is_coloured(shot(words, path), middle));
    BOOST_TEST(patches_of(shot(words, path)).size() == 2u);
    words.back() = "left";
    BOOST_TEST(!is_coloured(shot(words, path), aside));
}

BOOST_AUTO_TEST_CASE(a_ball_across_a_periodic_face_is_seen_on_both_sides) {
    std::vector<std::string> periodic{
        "--set", "container.boundary=\"periodic\"", "--azimuth", "-90", "--elevation", "0"};
    auto const at_a_face = scene_of("[0.2, 5.0, 5.0]", "[1.0, 0.0, 0.0]", 1);
    auto const both = patches_of(shot(periodic, at_a_face));
    BOOST_REQUIRE(both.size() == 2u);
    BOOST_TEST(std::abs(both[0].pixels - both[1].pixels) < 0.1 * both[0].pixels);
    // Left and right of the middle by nearly half a side, two tenths further right.
    double const side = std::abs(both[0].x - both[1].x);
    BOOST_TEST(std::abs((both[0].x + both[1].x - 319) / 2 - 0.02 * side) < 1);
    periodic.resize(2);
    auto const in_a_corner = scene_of("[0.2, 9.9, 0.1]", "[1.0, 0.0, 0.0]", 1);
    BOOST_TEST(patches_of(shot(periodic, in_a_corner)).size() == 8u);
}

BOOST_AUTO_TEST_CASE(a_movie_has_its_frames) {
    auto const path = two_balls();
    auto const movie = folder.file("movie.mp4");
    auto const outcome = run_clack(
        {"view", path, "--movie", movie, "--size", "160x120", "--duration", "0.5", "--fps", "20"});
    BOOST_TEST_REQUIRE(outcome.code == 0, outcome.err);
    // 0.5 s at 20 frames a second; a player would see them all.
    BOOST_TEST(probed(movie) == "h264,160,120,20/1,10\n");
    auto const again = folder.file("again.mp4");
    run_clack(
        {"view", path, "--movie", again, "--size", "160x120", "--duration", "0.5", "--fps", "20"});
    BOOST_TEST((text_of(movie) == text_of(again)));
}

BOOST_AUTO_TEST_CASE(without_opengl_or_ffmpeg_there_is_a_line) {
    auto const path = two_balls();
    auto const is_refused = [&](Outcome const& outcome, std::string const& part) {
        BOOST_TEST_CONTEXT(outcome.err) {
            BOOST_TEST(outcome.code == 2);
            BOOST_TEST(outcome.err_is_one_line());
            BOOST_TEST(outcome.err.find(part) != std::string::npos);
        }
    };
    is_refused(run_clack({"view", path, "--screenshot", folder.file("none.png")},
                         {"env", "__EGL_VENDOR_LIBRARY_DIRS=/nonexistent"}),
               "no OpenGL 3.3");
    is_refused(
        run_clack({"view", path, "--movie", folder.file("none.mp4")}, {"env", "PATH=/nonexistent"}),
        "ffmpeg cannot be started");
}

BOOST_AUTO_TEST_CASE(mistakes_get_one_line_and_no_file) {
    auto const path = two_balls();
    auto const output = folder.file("none.png");
    auto const is_refused = [&](std::vector<std::string> words, std::string const& part) {
        words.insert(words.begin(), "view");
        auto const outcome = run_clack(words);
        BOOST_TEST_CONTEXT(outcome.err) {
            BOOST_TEST(outcome.code == 2);
            BOOST_TEST(outcome.err_is_one_line());
            BOOST_TEST(outcome.err.find(part) != std::string::npos);
            BOOST_TEST(!std::filesystem::exists(output));
        }
    };
    auto const corrupt = folder.write("corrupt.h5", std::string(5000, 'x'));
    is_refused({corrupt, "--screenshot", output}, "not an HDF5 file");
    auto const cut_off = folder.file("cut_off.h5");
    BOOST_REQUIRE(run_clack({"run", path, "-o", cut_off, "--quiet"}).code == 0);
    std::filesystem::resize_file(cut_off, std::filesystem::file_size(cut_off) / 2);
    is_refused({cut_off, "--screenshot", output}, "cut_off.h5");
    is_refused({path, "--screenshot", folder.file("no/folder.png")}, "no folder");
    is_refused({path, "--screenshot", output, "--size", "3x3"}, "WIDTHxHEIGHT");
    is_refused({path, "--screenshot", output, "--colour", "pink"}, "must be one of");
    is_refused({path, "--screenshot", output, "--time", "-1"}, "time = -1");
    is_refused({path, "--movie", folder.file("movie.avi")}, "must end in .mp4");
    is_refused({path, "--movie", folder.file("odd.mp4"), "--size", "161x120"}, "must be even");
}
