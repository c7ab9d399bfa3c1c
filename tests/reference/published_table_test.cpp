#include "reference/published_table.hpp"

#include <boost/test/unit_test.hpp>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <stdexcept>

using namespace clack::reference;

namespace {

/// A file that goes when the test does.
struct TemporaryFile {
    std::filesystem::path path;
    explicit TemporaryFile(std::string const& text)
        : path(std::filesystem::temp_directory_path() / "clack_published_table_test.csv") {
        std::ofstream(path) << text;
    }
    ~TemporaryFile() { std::filesystem::remove(path); }
};

bool names_line_3(std::runtime_error const& error) {
    return std::string(error.what()).find(".csv:3: ") != std::string::npos;
}

} // namespace

BOOST_AUTO_TEST_CASE(columns_are_found_by_name) {
    TemporaryFile const file("# from somewhere\na,b\n1,2\n3,4e-1\n");
    PublishedTable const table(file.path);
    BOOST_TEST(table.row_count() == 2);
    BOOST_TEST(table.column("b")[1] == 0.4);
    BOOST_TEST(table.comments().at(0) == "# from somewhere");
    BOOST_CHECK_THROW(table.column("c"), std::out_of_range);
}

BOOST_AUTO_TEST_CASE(bad_lines_are_named) {
    TemporaryFile const short_row("# x\na,b\n1\n");
    BOOST_CHECK_EXCEPTION(PublishedTable{short_row.path}, std::runtime_error, names_line_3);
    TemporaryFile const word("# x\na,b\n1,two\n");
    BOOST_CHECK_EXCEPTION(PublishedTable{word.path}, std::runtime_error, names_line_3);
    BOOST_CHECK_THROW(PublishedTable("/nowhere/at/all.csv"), std::runtime_error);
}

BOOST_AUTO_TEST_CASE(every_table_of_the_reference_says_where_it_comes_from) {
    int tables = 0;
    for (auto const& entry : std::filesystem::directory_iterator(CLACK_REFERENCE_DIR)) {
        if (entry.path().extension() != ".csv") continue;
        PublishedTable const table(entry.path());
        BOOST_TEST(table.comments().size() >= 2, entry.path().string());
        BOOST_TEST(table.row_count() >= 1, entry.path().string());
        ++tables;
    }
    BOOST_TEST(tables >= 3);
}
