// image_file.h — pictures to files and back: PNG, JPEG, EXR, TIF.
//
// PNG is written by our own code (png.h). For the others the image library stands in one module that is opened when first needed (it drags hundreds
// of shared objects into the process); opening can begin on another thread while the rendering runs. The module encodes into memory and this side writes the file: to a temporary name, then renamed,
// so that a failure (a full disk too) leaves what was there before. Same pixels, same bytes: no time stamps.
#pragma once

#include <cstdint>
#include <filesystem>
#include <future>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "csg/base/result.h"
#include "tracer/image/film.h"
#include "tracer/image/tone.h"

namespace whittle {

enum class ImageFormat { kPng, kJpeg, kExr, kTiff };
// By the suffix of `path`, upper or lower case.
std::optional<ImageFormat> image_format_of(std::string_view path);

enum class ChannelType : std::uint8_t { kByte = 0, kHalf = 1, kFloat = 2 };

// Interleaved channels, rows from the top; either `bytes` or `floats` is filled.
struct Image {
    int width = 0, height = 0;
    std::vector<std::string> channels;  // "R", "G", "B", "depth.Z", ...
    std::vector<ChannelType> types;     // as stored in an EXR
    std::vector<std::uint8_t> bytes;
    std::vector<float> floats;
};

// What a film becomes in a file. `color_type` is for EXR.
struct PictureOptions {
    Tone tone;
    ChannelType color_type = ChannelType::kHalf;
};

// EXR: linear radiances times the exposure, coverage as A, and every plane of the film. Others: eight bits through the tone curve.
// kCommand: the film has planes and the format has no place for them.
Result<Image> image_of(const Film& film, ImageFormat format, const PictureOptions& options);

// The module's places, likeliest first, for a program in `program_dir`.
std::vector<std::filesystem::path> image_module_places(const std::filesystem::path& program_dir);
// The folder of the running program.
std::filesystem::path running_program_dir();

// Encodes and decodes by the module; opens it once, when first needed.
class ImageFiles {
public:
    explicit ImageFiles(std::filesystem::path program_dir = running_program_dir());
    ~ImageFiles();
    ImageFiles(const ImageFiles&) = delete;
    ImageFiles& operator=(const ImageFiles&) = delete;

    // Begins to open the module on another thread.
    void start_loading();
    // The same, unless `path` can be written without the module: a PNG can.
    void start_loading_for(const std::filesystem::path& path);
    // Was the module opened? (--stats loaded.image)
    bool loaded() const { return opened_; }

    Result<std::string> encode(const Image& image, ImageFormat format);
    Result<void> write(const std::filesystem::path& path, const Image& image);
    // Floats of all channels of any file the library reads.
    Result<Image> read(const std::filesystem::path& path);

private:
    struct Module {  // entry points, typed in module/image_module.h
        void* encode = nullptr;
        void* decode = nullptr;
    };
    static Result<Module> open_module(const std::filesystem::path& program_dir);
    Result<const Module*> module();

    std::filesystem::path program_dir_;
    std::future<Result<Module>> loading_;
    std::optional<Result<Module>> module_;
    bool opened_ = false;
};

}  // namespace whittle
