#pragma once
// What nearly every test reads, parsed once.

#include "framework/cmake/precompiled.hpp"

#include <catch2/catch.hpp>
