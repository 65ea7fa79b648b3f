#pragma once

#include "../../kernels/exec/array.hpp"

namespace pinball {

template <class T>
using AlignedArray = Array<T, HostSpace>;

}  // namespace pinball
