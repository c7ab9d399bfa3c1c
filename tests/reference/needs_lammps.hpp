#pragma once
// Tests that run LAMMPS are skipped, with a word, where it is not installed as the decks want it.

#include "reference/lammps.hpp"

#include <boost/test/unit_test.hpp>

/// To be hung on a test case: *NeedsLammps().
struct NeedsLammps : boost::unit_test::precondition {
    NeedsLammps() : precondition(&is_there) {}

    static boost::test_tools::assertion_result is_there(boost::unit_test::test_unit_id) {
        using namespace clack::reference;
        try {
            run_lammps(LammpsFolder(), "print ready\n", {{}});
        } catch (LammpsError const& error) {
            boost::test_tools::assertion_result no(false);
            no.message() << error.what();
            return no;
        }
        return true;
    }
};
