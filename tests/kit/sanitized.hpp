#pragma once

/// Whether the tests run under a sanitizer: everything takes several times as long then, and needs more memory.
#ifdef OPAL_IS_SANITIZED
inline constexpr bool kIsSanitized = true;
#else
inline constexpr bool kIsSanitized = false;
#endif
