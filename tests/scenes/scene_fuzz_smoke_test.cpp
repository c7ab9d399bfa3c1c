// Damaged scene files: whatever is in them, the reader accepts them or says what is wrong.

#include "scenes/draw.hpp"
#include "tests/scenes/scene_text.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>

using namespace clack;

namespace {

constexpr int copies_per_scene = 600;

std::size_t below(Generator& generator, std::size_t end) { return generator() % end; }

std::vector<std::string> lines_of(std::string const& text) {
    std::vector<std::string> lines;
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);) lines.push_back(line);
    return lines;
}

std::string joined(std::vector<std::string> const& lines) {
    std::string text;
    for (auto const& line : lines) text += line + "\n";
    return text;
}

std::string any_value(Generator& generator) {
    static std::vector<std::string> const values{"0",
                                                 "-1",
                                                 "1",
                                                 "nan",
                                                 "inf",
                                                 "-inf",
                                                 "1e308",
                                                 "1e-320",
                                                 "9223372036854775807",
                                                 "-0.0",
                                                 "0x7f",
                                                 "\"\"",
                                                 "\"walls\"",
                                                 "\"explicit\"",
                                                 "\"file\"",
                                                 "\"random\"",
                                                 "true",
                                                 "[]",
                                                 "[[]]",
                                                 "[[1, 2, 3]]",
                                                 "[[nan, 0, 0]]",
                                                 "{}",
                                                 "1979-05-27",
                                                 "0.74",
                                                 "0.7405",
                                                 "1.0000001",
                                                 "3",
                                                 "\"\\u0007\\n\"",
                                                 "'''\n'''",
                                                 "134217727",
                                                 "1e-3",
                                                 "\"quad\"",
                                                 "\"float\""};
    return values[below(generator, values.size())];
}

void flip_byte(std::string& text, Generator& generator) {
    if (text.empty()) return;
    text[below(generator, text.size())] = static_cast<char>(generator());
}

void delete_span(std::string& text, Generator& generator) {
    if (text.empty()) return;
    text.erase(below(generator, text.size()), 1 + below(generator, 12));
}

void move_line(std::string& text, Generator& generator) {
    auto lines = lines_of(text);
    if (lines.empty()) return;
    auto const line = lines[below(generator, lines.size())];
    auto const place = below(generator, lines.size());
    lines.insert(lines.begin() + static_cast<std::ptrdiff_t>(place), line);
    text = joined(lines);
}

/// Puts another value behind a key: one from the list, one of another line, or a random number.
void change_value(std::string& text, Generator& generator) {
    auto lines = lines_of(text);
    if (lines.empty()) return;
    auto const& other = lines[below(generator, lines.size())];
    std::string const number = std::to_string(
        std::ldexp(uniform_about_zero(generator), static_cast<int>(below(generator, 80)) - 40));
    auto& line = lines[below(generator, lines.size())];
    auto const equals = line.find('=');
    if (equals == std::string::npos) return;
    auto const other_equals = other.find('=');
    std::size_t const kind = below(generator, 3);
    std::string const value = kind == 0 ? any_value(generator)
                              : kind == 1 && other_equals != std::string::npos
                                  ? other.substr(other_equals + 1)
                                  : number;
    line = line.substr(0, equals + 1) + " " + value;
    text = joined(lines);
}

std::string damaged(std::string text, Generator& generator) {
    std::size_t const wounds = 1 + below(generator, 3);
    for (std::size_t wound = 0; wound < wounds; ++wound) switch (below(generator, 4)) {
        case 0:
            flip_byte(text, generator);
            break;
        case 1:
            delete_span(text, generator);
            break;
        case 2:
            move_line(text, generator);
            break;
        default:
            change_value(text, generator);
        }
    return text;
}

/// Parses, and starts what is small and needs no growth of balls, which takes its time.
bool accepted(std::string const& text) {
    try {
        Scene const scene = parse_scene(text, "damaged.toml");
        BOOST_TEST(scene.system.count >= 1);
        BOOST_TEST(std::isfinite(scene.system.side));
        bool const quick =
            scene.arrangement != Arrangement::random || scene.system.packing_fraction() < 0.1;
        if (scene.system.count < 1000 && quick) make_start(scene);
        return true;
    } catch (InputError const& error) {
        std::string const message = error.what();
        bool const printable = std::none_of(message.begin(), message.end(), [](char c) {
            return static_cast<unsigned char>(c) < 0x20 || c == 0x7f;
        });
        BOOST_TEST(printable, message);
        BOOST_TEST((message.size() > 10 && message.size() < 600), message);
        return false;
    }
}

} // namespace

BOOST_AUTO_TEST_CASE(damaged_scenes_parse_or_say_what_is_wrong_in_one_line) {
    Generator generator(2015);
    int copies = 0, accepted_copies = 0;
    for (auto const& entry :
         std::filesystem::directory_iterator(CLACK_SOURCE_DIR "/validation/scenes")) {
        std::ifstream file(entry.path());
        std::string const text(std::istreambuf_iterator<char>(file), {});
        for (int copy = 0; copy < copies_per_scene; ++copy, ++copies) {
            auto const wounded = damaged(text, generator);
            BOOST_TEST_CONTEXT(wounded) accepted_copies += accepted(wounded);
        }
    }
    BOOST_TEST_MESSAGE(accepted_copies << " of " << copies << " accepted");
    BOOST_TEST(copies >= 4000);
    // Wounds in comments and of harmless values leave scenes whole; most others do not.
    BOOST_TEST(accepted_copies > copies / 20);
    BOOST_TEST(accepted_copies < copies * 3 / 4);
}

BOOST_AUTO_TEST_CASE(a_file_without_end_is_refused) {
    auto const message = test::message_of([] { read_scene("/dev/zero"); });
    BOOST_TEST(test::beginning(message, "/dev/zero: is larger than 64 MiB") ==
               "/dev/zero: is larger than 64 MiB");
}

// Comparing all pairs would take minutes.
BOOST_AUTO_TEST_CASE(many_balls_in_one_place_are_refused_soon, *boost::unit_test::timeout(30)) {
    Scene scene;
    scene.system = {Boundary::walls, 1000, 100000, 1, 1};
    scene.arrangement = Arrangement::file;
    Eigen::Matrix3Xd const places = Eigen::Matrix3Xd::Constant(3, scene.system.count, 5);
    auto const message = test::message_of([&] {
        make_start(scene, [&](std::string const&) { return Start{places, places}; });
    });
    BOOST_TEST(message.starts_with("balls 0 and 1 overlap by 1 diameters"), message);
}
