#ifndef MesoEGLChoice_h
#define MesoEGLChoice_h

/**
 * @file MesoEGLChoice.h
 * @brief Which of EGL's candidates is drawn with.
 */

#include "MesoEGLContext.h"

#include <string> // for the text
#include <vector> // for the list

/**
 * Makes a context on the candidate whose index `wanted` names, or, where `wanted` is empty or null,
 * on the first that gives one. A candidate that calls itself hardware but draws on the CPU (Mesa
 * without a driver for the card does that) is taken only when nothing else is left.
 *
 * On success `text` is one line: what was taken, and which hardware was passed over and why. On
 * failure it says what is wrong and lists every candidate with its index, name and reason.
 */
bool MesoChooseEGLContext(MesoEGLContext& context, const std::vector<MesoEGLCandidate>& candidates,
  const char* wanted, bool debug, std::string& text);

#endif
