// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_precompiled_h
#define voussoir_precompiled_h

// The headers that most source files need and that take longest to read.
#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <filesystem>
#include <iostream>
#include <memory>
#include <string>
#include <vector>

#endif
