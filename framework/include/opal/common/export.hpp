/// @file
/// The macro OPAL_EXPORT.
#pragma once

/// Marks what crosses the boundary of libopal.so; everything else is hidden.
#define OPAL_EXPORT __attribute__((visibility("default")))
