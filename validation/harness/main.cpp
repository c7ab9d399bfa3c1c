// The main of every experiment.

#include "validation/harness/experiment.hpp"

int main(int argc, char** argv) {
    using namespace clack::validation;
    return run(argc, argv, question, ask);
}
