#include "simulation/build_engine.hpp"

namespace clack {

template std::unique_ptr<Engine> build_engine<float>(System const&, Method, Precision,
                                                     Origin const&);

} // namespace clack
