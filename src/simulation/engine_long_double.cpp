#include "simulation/build_engine.hpp"

namespace clack {

template std::unique_ptr<Engine> build_engine<long double>(System const&, Method, Precision,
                                                           Origin const&);

} // namespace clack
