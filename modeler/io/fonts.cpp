#include "modeler/io/fonts.h"

#include <atomic>

#include "csg/base/module_file.h"

namespace whittle {
namespace {

std::atomic<bool>& loaded() {
    static std::atomic<bool> flag = false;
    return flag;
}

Result<Fonts*> opened() {
    const auto entry = module_entry("whittle_font.so", "whittle_fonts", "the part that reads fonts");
    if (!entry) return tl::unexpected(entry.error());
    loaded() = true;
    Fonts* fonts = reinterpret_cast<Fonts* (*)()>(*entry)();
    if (!fonts) return fail(Fault::kWorld, "fontconfig or FreeType cannot be started");
    return fonts;
}

}  // namespace

Result<Fonts*> system_fonts() {
    static const Result<Fonts*> fonts = opened();
    return fonts;
}

bool fonts_are_loaded() { return loaded(); }

}  // namespace whittle
