#ifndef MesoMessage_h
#define MesoMessage_h

/**
 * @file MesoMessage.h
 * @brief Text and numbers as they may stand in a message of one line.
 */

#include "mesoIOMesostructureModule.h" // for export macro

#include <string>

/// Text of unknown origin without control characters, cut at 160 characters.
MESOIOMESOSTRUCTURE_EXPORT std::string MesoPrintable(const std::string& text);

/// A number in the fewest digits that give it back.
MESOIOMESOSTRUCTURE_EXPORT std::string MesoNumberText(double value);

#endif
