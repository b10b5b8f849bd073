#pragma once

#include "stream_books.hpp"

#include "viewer/words/explanation.hpp"

/// Checks that what a sentence says is in the books of the stream so far: ids, places, times, numbers, reasons.
void check_sentence(const opal::Sentence& sentence, const StreamBooks& books);
