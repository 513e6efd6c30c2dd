// certificates.h — does this build bound its errors? Private to the engine.
//
// What is shipped does. A build with the CMake option WHITTLE_CERTIFICATES off takes each t as double gives it, never looks twice and says so of every end
// (End::certified): it is there to be raced against the other (bench/compare_commits.py --later-options), so that what certificates cost is a number.
#pragma once

namespace whittle {

#ifdef WHITTLE_UNCERTIFIED
inline constexpr bool kCertifies = false;
#else
inline constexpr bool kCertifies = true;
#endif

}  // namespace whittle
