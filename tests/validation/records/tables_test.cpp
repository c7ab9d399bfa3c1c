#include "validation/records/tables.hpp"

#include <boost/test/unit_test.hpp>

#include <stdexcept>

using namespace clack::validation;

BOOST_AUTO_TEST_CASE(error_stands_in_the_last_digits) {
    BOOST_TEST(with_error({3.26941234, 0.00123}) == "3.2694(12)");
    BOOST_TEST(with_error({-0.5, 0.0999}) == "-0.50(10)");
    BOOST_TEST(with_error({12.345, 4.5}) == "12.3(4.5)");
    BOOST_TEST(with_error({123.4, 12}) == "123(12)");
    BOOST_TEST(with_error({12344, 678}) == "12340(680)");
    BOOST_TEST(with_error({1.5, 0}) == "1.5");
}

BOOST_AUTO_TEST_CASE(significant_digits_are_kept) {
    BOOST_TEST(significant(0.012345, 3) == "0.0123");
    BOOST_TEST(significant(1234.5, 2) == "1234");
    BOOST_TEST(significant(9.99e-5, 2) == "$1.0 \\times 10^{-4}$");
    BOOST_TEST(significant(-2.5e7, 2) == "$-2.5 \\times 10^{7}$");
    BOOST_TEST(significant(0, 2) == "0");
}

BOOST_AUTO_TEST_CASE(macros_are_what_tex_takes) {
    Macros macros("EquationOfState");
    macros.define("LargestZ", "1.2");
    BOOST_TEST(macros.text({"from here"}) ==
               "% from here\n\\newcommand{\\EquationOfStateLargestZ}{1.2}\n");
    BOOST_CHECK_THROW(macros.define("LargestZ", "1.3"), std::invalid_argument);
    BOOST_CHECK_THROW(macros.define("Z2", "1.3"), std::invalid_argument);
    BOOST_CHECK_THROW(macros.define("Large_Z", "1.3"), std::invalid_argument);
}

BOOST_AUTO_TEST_CASE(tabular_is_a_booktabs_one) {
    BOOST_TEST(tabular("rl", {"$n$", "verdict"}, {{"8", "agrees"}, {"32", "differs"}}) ==
               "\\begin{tabular}{rl}\n\\toprule\n$n$ & verdict \\\\\n\\midrule\n"
               "8 & agrees \\\\\n32 & differs \\\\\n\\bottomrule\n\\end{tabular}\n");
}

BOOST_AUTO_TEST_CASE(csv_has_a_cell_for_each_column) {
    Csv csv({"count", "speed", "verdict"});
    csv.row({cell(8), cell(0.1), cell("agrees")});
    csv.row(8, Estimate{0.5, 0.25}); // a value and its error
    BOOST_TEST(csv.text({"why"}) == "# why\ncount,speed,verdict\n8,0.1,agrees\n8,0.5,0.25\n");
    BOOST_CHECK_THROW(csv.row({cell(8)}), std::invalid_argument);
    BOOST_CHECK_THROW(csv.row({cell(8), cell(0.1), cell("a,b")}), std::invalid_argument);
}

BOOST_AUTO_TEST_CASE(plain_text_is_escaped) {
    BOOST_TEST(in_tex("0.2 % of Z_c < {1}") == "0.2 \\% of Z\\_c $<$ \\{1\\}");
}
