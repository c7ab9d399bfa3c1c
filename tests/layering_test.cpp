// The layers are an order: a file includes its own layer and lower ones only. The order stands in
// the README, for people, and is read from there.

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <optional>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace {

namespace fs = std::filesystem;

std::string text_of(fs::path const& path) {
    std::ifstream file(path);
    return {std::istreambuf_iterator<char>(file), {}};
}

std::vector<std::string> lines_of(std::string const& text) {
    std::vector<std::string> lines;
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);) lines.push_back(line);
    return lines;
}

/// The folders in the first column of the README's table, lowest layer first.
std::vector<std::string> layers_of(std::string const& readme) {
    auto const begin = readme.find("<!-- layers -->");
    auto const end = readme.find("<!-- end of layers -->");
    if (begin == std::string::npos || end == std::string::npos) return {};
    std::vector<std::string> layers;
    for (std::string const& line : lines_of(readme.substr(begin, end - begin))) {
        if (!line.starts_with("| `")) continue;
        std::string const folder = line.substr(3, line.find('`', 3) - 3);
        layers.push_back(folder.ends_with('/') ? folder.substr(0, folder.size() - 1) : folder);
    }
    return layers;
}

/// What a line includes, between its brackets or quotation marks; the opening one stands first.
std::optional<std::string> include_of(std::string line) {
    std::erase_if(line, [](char const c) { return c == ' ' || c == '\t'; });
    if (!line.starts_with("#include") || line.size() < 10) return std::nullopt;
    return line.substr(8, line.find_first_of(">\"", 9) - 8);
}

/// The layer that a path relative to the root lies in: "src/state/real.hpp" in "src/state".
std::string layer_of(fs::path const& path) {
    auto part = path.begin();
    std::string const top = part->string();
    return top == "src" ? top + "/" + std::next(part)->string() : top;
}

/// Where an include leads to, relative to the root; empty for a header of a library.
fs::path included_path(fs::path const& root, std::string const& name) {
    for (fs::path const folder : {"src", ""}) {
        if (fs::exists(root / folder / name)) {
            return folder / name;
        }
    }
    return {};
}

/// One line for each folder and each include of a file that breaks the order.
class LayerOrder {
public:
    explicit LayerOrder(fs::path root)
        : root_(std::move(root)), layers_(layers_of(text_of(root_ / "README.md"))) {}

    std::set<std::string> violations() {
        check_folders();
        for (std::string const& layer : layers_) {
            if (!fs::is_directory(root_ / layer)) {
                continue;
            }
            for (auto const& entry : fs::recursive_directory_iterator(root_ / layer)) {
                std::string const extension = entry.path().extension().string();
                if (extension == ".hpp" || extension == ".cpp") {
                    check_file(entry.path());
                }
            }
        }
        return violations_;
    }

private:
    void check_folders() {
        for (std::string const& layer : layers_) {
            if (!fs::exists(root_ / layer)) {
                violations_.insert(layer + " does not exist");
            }
        }
        std::vector<fs::path> folders{"reference", "validation", "tests", "paper"};
        for (auto const& entry : fs::directory_iterator(root_ / "src")) {
            folders.push_back(fs::path("src") / entry.path().filename());
        }
        for (fs::path const& folder : folders) {
            if (fs::exists(root_ / folder) && rank(folder.string()) == layers_.size()) {
                violations_.insert(folder.string() + " is not in the README");
            }
        }
    }

    void check_file(fs::path const& file) {
        fs::path const here = fs::relative(file, root_);
        for (std::string const& line : lines_of(text_of(file))) {
            auto const include = include_of(line);
            if (!include) continue;
            std::string const name = include->substr(1);
            fs::path const there = included_path(root_, name);
            if (!there.empty()) {
                if (rank(layer_of(there)) > rank(layer_of(here)))
                    violations_.insert(here.string() + " includes the higher " + there.string());
            } else if (include->front() == '"') {
                violations_.insert(here.string() + " includes " + name +
                                   ", which is neither below src/ nor below the root");
            }
        }
    }

    /// Place in the order; the number of layers for a folder that has none.
    std::size_t rank(std::string const& layer) const {
        return static_cast<std::size_t>(
            std::distance(layers_.begin(), std::find(layers_.begin(), layers_.end(), layer)));
    }

    fs::path root_;
    std::vector<std::string> layers_;
    std::set<std::string> violations_;
};

/// A small project of made-up files that is gone after the test.
class MadeUpProject {
public:
    MadeUpProject() {
        std::string name = (fs::temp_directory_path() / "clack_layers_XXXXXX").string();
        BOOST_REQUIRE(mkdtemp(name.data()) != nullptr);
        root_ = name;
        write("README.md", "<!-- layers -->\n| layer | what |\n|---|---|\n| `src/low` | a |\n"
                           "| `src/high` | b |\n| `reference/` | c |\n<!-- end of layers -->\n");
        write("src/low/a.hpp", "#include <vector>\n");
        write("src/high/b.cpp", "#include \"low/a.hpp\"\n");
        write("reference/c.hpp", "#include \"high/d.hpp\"\n");
        write("src/high/d.hpp", "");
    }
    ~MadeUpProject() { fs::remove_all(root_); }

    void write(fs::path const& path, std::string const& text) const {
        fs::create_directories((root_ / path).parent_path());
        std::ofstream(root_ / path) << text;
    }
    fs::path const& root() const { return root_; }

private:
    fs::path root_;
};

std::string joined(std::set<std::string> const& lines) {
    std::string text;
    for (std::string const& line : lines) {
        text += line + "\n";
    }
    return text;
}

} // namespace

BOOST_AUTO_TEST_CASE(readme_names_the_layers) {
    BOOST_TEST(layers_of(text_of(fs::path(CLACK_SOURCE_DIR) / "README.md")).size() >= 10);
}

BOOST_AUTO_TEST_CASE(each_file_includes_its_own_layer_and_lower_ones_only) {
    BOOST_TEST(joined(LayerOrder(CLACK_SOURCE_DIR).violations()) == "");
}

BOOST_FIXTURE_TEST_CASE(a_project_in_order_has_no_violation, MadeUpProject) {
    BOOST_TEST(joined(LayerOrder(root()).violations()) == "");
}

BOOST_FIXTURE_TEST_CASE(an_include_of_a_higher_layer_is_found, MadeUpProject) {
    write("src/low/e.hpp", "#pragma once\n#include \"high/d.hpp\"\n");
    BOOST_TEST(joined(LayerOrder(root()).violations()) ==
               "src/low/e.hpp includes the higher src/high/d.hpp\n");
}

BOOST_FIXTURE_TEST_CASE(an_include_of_the_reference_by_the_engine_is_found, MadeUpProject) {
    write("src/high/e.cpp", "#  include <reference/c.hpp>\n");
    BOOST_TEST(joined(LayerOrder(root()).violations()) ==
               "src/high/e.cpp includes the higher reference/c.hpp\n");
}

BOOST_FIXTURE_TEST_CASE(an_include_beside_the_file_is_found, MadeUpProject) {
    write("src/high/e.cpp", "#include \"d.hpp\"\n");
    BOOST_TEST(joined(LayerOrder(root()).violations()) ==
               "src/high/e.cpp includes d.hpp, which is neither below src/ nor below the root\n");
}

BOOST_FIXTURE_TEST_CASE(a_folder_without_a_row_is_found, MadeUpProject) {
    write("src/other/e.hpp", "");
    write("tests/e.cpp", "");
    BOOST_TEST(joined(LayerOrder(root()).violations()) ==
               "src/other is not in the README\ntests is not in the README\n");
}

BOOST_FIXTURE_TEST_CASE(a_row_without_a_folder_is_found, MadeUpProject) {
    write("README.md",
          "<!-- layers -->\n| `src/low` | a |\n| `src/gone` | x |\n| `src/high` | b |\n"
          "| `reference/` | c |\n<!-- end of layers -->\n");
    BOOST_TEST(joined(LayerOrder(root()).violations()) == "src/gone does not exist\n");
}
