#pragma once

/// Catch2's command line; what main() of a test program returns.
int run_tests(int argc, char** argv);
