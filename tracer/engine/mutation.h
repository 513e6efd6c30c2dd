// mutation.h — faults that a test's own build of the engine can be told to have, to prove that the tests would notice them.
//
// In the engine that is shipped every question below is a constant "no": no fault, no cost. tests/mutations builds the folder a second time with
// WHITTLE_MUTATIONS and turns one fault on after the other.
#pragma once

#include <cstdint>

namespace whittle {

enum class Mutation : std::uint8_t {
    kNone,
    kNoBounds,             // every error bound is 0
    kNoExactTier,          // what double-double cannot decide is guessed from its value
    kOwnIdentity,          // every primitive has surfaces of its own, also where they coincide
    kRayEpsilon,           // events within 1e-12 on a ray are one
    kReversedRule,         // rays in a face take the other side
    kEpsilonContinuation,  // rays that leave a surface start a little way along instead
    kCausesInBoxesOnly     // who made a border is asked only of leaves whose boxes hold its t
};

#ifdef WHITTLE_MUTATIONS
extern Mutation present_mutation;
inline bool mutated(Mutation m) { return present_mutation == m; }
#else
constexpr bool mutated(Mutation) { return false; }
#endif

}  // namespace whittle
