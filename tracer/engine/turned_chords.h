// turned_chords.h — what rays meet instead of a turned parabola or ellipse.
#pragma once

namespace whittle {

// These are surfaces of degree four that the engine has no roots for: cones through chords within this share of the profile's size.
inline constexpr double kTurnedTolerance = 0x1p-12;

}  // namespace whittle
