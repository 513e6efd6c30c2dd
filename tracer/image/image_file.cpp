#include "tracer/image/image_file.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <system_error>

#include <dlfcn.h>

#include <fmt/format.h>

#include "csg/base/file.h"
#include "tracer/image/module/image_module.h"
#include "tracer/image/png.h"

namespace whittle {

namespace {

constexpr const char* kModuleName = "whittle_image.so";

const char* library_format(ImageFormat format) {
    switch (format) {
        case ImageFormat::kPng: return "png";
        case ImageFormat::kJpeg: return "jpeg";
        case ImageFormat::kExr: return "openexr";
        case ImageFormat::kTiff: return "tiff";
    }
    return "png";
}

}  // namespace

std::optional<ImageFormat> image_format_of(std::string_view path) {
    const std::size_t dot = path.rfind('.');
    if (dot == std::string_view::npos) return std::nullopt;
    std::string suffix(path.substr(dot + 1));
    for (char& c : suffix) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    if (suffix == "png") return ImageFormat::kPng;
    if (suffix == "jpg" || suffix == "jpeg") return ImageFormat::kJpeg;
    if (suffix == "exr") return ImageFormat::kExr;
    if (suffix == "tif" || suffix == "tiff") return ImageFormat::kTiff;
    return std::nullopt;
}

std::vector<std::filesystem::path> image_module_places(const std::filesystem::path& program_dir) {
    return {program_dir / ".." / "lib" / "whittle" / kModuleName, program_dir / kModuleName, program_dir / "lib" / kModuleName,
            program_dir / ".." / kModuleName};
}

std::filesystem::path running_program_dir() {
    std::error_code ignored;
    return std::filesystem::read_symlink("/proc/self/exe", ignored).parent_path();
}

// The opened library stays open until the program ends: its threads may outlive any close.
Result<ImageFiles::Module> ImageFiles::open_module(const std::filesystem::path& program_dir) {
    std::string reason;
    for (const std::filesystem::path& place : image_module_places(program_dir)) {
        std::error_code ignored;
        if (!std::filesystem::exists(place, ignored)) continue;
        void* handle = dlopen(place.c_str(), RTLD_NOW | RTLD_LOCAL);
        if (!handle) {
            reason = dlerror();
            continue;
        }
        const auto abi = reinterpret_cast<int (*)()>(dlsym(handle, "whittle_image_abi"));
        if (!abi || abi() != WHITTLE_IMAGE_ABI) {
            reason = fmt::format("{} belongs to another version", place.string());
            continue;
        }
        Module found{dlsym(handle, "whittle_image_encode"), dlsym(handle, "whittle_image_decode")};
        if (found.encode && found.decode) return found;
    }
    if (reason.empty()) reason = fmt::format("not found near {}", program_dir.string());
    return fail(Fault::kWorld, fmt::format("Can't open the image module {}: {}", kModuleName, reason));
}

namespace {

int take_bytes(void* sink, const void* data, std::size_t size) {
    try {
        static_cast<std::string*>(sink)->assign(static_cast<const char*>(data), size);
        return 1;
    } catch (const std::bad_alloc&) {
        return 0;
    }
}

float* make_room(void* sink, int width, int height, int channels, const char* const* names) {
    try {
        Image& image = *static_cast<Image*>(sink);
        image.width = width;
        image.height = height;
        image.channels.assign(names, names + channels);
        image.types.assign(static_cast<std::size_t>(channels), ChannelType::kFloat);
        image.floats.resize(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * static_cast<std::size_t>(channels));
        return image.floats.data();
    } catch (const std::bad_alloc&) {
        return nullptr;
    }
}

}  // namespace

ImageFiles::ImageFiles(std::filesystem::path program_dir) : program_dir_(std::move(program_dir)) {}
ImageFiles::~ImageFiles() = default;

void ImageFiles::start_loading_for(const std::filesystem::path& path) {
    if (image_format_of(path.string()) != ImageFormat::kPng) start_loading();
}

void ImageFiles::start_loading() {
    if (module_ || loading_.valid()) return;
    loading_ = std::async(std::launch::async, &ImageFiles::open_module, program_dir_);
}

Result<const ImageFiles::Module*> ImageFiles::module() {
    if (!module_) {
        module_.emplace(loading_.valid() ? loading_.get() : open_module(program_dir_));
        opened_ = module_->has_value();
    }
    if (!*module_) return tl::unexpected<Error>(module_->error());
    return &**module_;
}

Result<std::string> ImageFiles::encode(const Image& image, ImageFormat format) {
    if (format == ImageFormat::kPng && !image.bytes.empty()) return png_encoded(image.width, image.height, static_cast<int>(image.channels.size()), image.bytes);
    const Result<const Module*> opened = module();
    if (!opened) return tl::unexpected<Error>(opened.error());
    std::vector<const char*> names;
    for (const std::string& name : image.channels) names.push_back(name.c_str());
    std::vector<unsigned char> types;
    for (ChannelType type : image.types) types.push_back(static_cast<unsigned char>(type));
    std::string bytes;
    WhittleEncodeJob job{};
    job.format = library_format(format);
    job.width = image.width;
    job.height = image.height;
    job.channels = static_cast<int>(image.channels.size());
    job.names = names.data();
    job.types = types.data();
    job.bytes = image.bytes.empty() ? nullptr : image.bytes.data();
    job.floats = image.floats.empty() ? nullptr : image.floats.data();
    job.sink = &bytes;
    job.write = &take_bytes;
    std::array<char, 512> message{};
    if (!reinterpret_cast<WhittleEncode>((*opened)->encode)(&job, message.data(), message.size())) return fail(Fault::kWorld, fmt::format("Can't write the picture: {}", message.data()));
    return bytes;
}

Result<void> ImageFiles::write(const std::filesystem::path& path, const Image& image) {
    const std::optional<ImageFormat> format = image_format_of(path.string());
    if (!format) return fail(Fault::kCommand, fmt::format("Unknown picture format: {}", path.string()));
    const Result<std::string> bytes = encode(image, *format);
    if (!bytes) return tl::unexpected<Error>(bytes.error());
    return write_file_atomically(path.string(), *bytes);
}

Result<Image> ImageFiles::read(const std::filesystem::path& path) {
    const Result<const Module*> opened = module();
    if (!opened) return tl::unexpected<Error>(opened.error());
    Image image;
    const std::string name = path.string();
    WhittleDecodeJob job{name.c_str(), &image, &make_room};
    std::array<char, 512> message{};
    if (!reinterpret_cast<WhittleDecode>((*opened)->decode)(&job, message.data(), message.size())) return fail(Fault::kWorld, fmt::format("Can't read '{}': {}", name, message.data()));
    return image;
}

}  // namespace whittle
