#include "simulation/build_engine.hpp"

namespace clack {

template std::unique_ptr<Engine> build_engine<quad>(System const&, Method, Precision,
                                                    Origin const&);

} // namespace clack
