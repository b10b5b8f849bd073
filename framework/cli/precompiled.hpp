#pragma once
// What nearly every verb reads, parsed once.

#include "cmake/precompiled.hpp"

#include <CLI/CLI.hpp>
