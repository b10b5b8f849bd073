// synthetic_run FILE [UPDATES HYPOTHESES POINTS TIME_LINES]: writes a synthetic event stream, to measure `opal
// view` with.
#include "tests/viewer/synthetic_run.hpp"

#include <cstdlib>
#include <fstream>
#include <iostream>

int main(int argc, char** argv) {
  if (argc < 2) {
    std::cerr << "usage: synthetic_run FILE [UPDATES HYPOTHESES POINTS TIME_LINES]\n";
    return 2;
  }
  const auto number = [&](int place, int otherwise) { return argc > place ? std::atoi(argv[place]) : otherwise; };
  std::ofstream file(argv[1]);
  opal::JsonLinesSink sink(file);
  opal::synthetic::write_run({number(2, 10000), number(3, 200), number(4, 360), number(5, 1)}, sink);
  return file ? 0 : 3;
}
