#include "statistics/comparison.hpp"
