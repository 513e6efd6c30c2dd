// image_module.cpp — the only file that knows OpenImageIO. Built as a module; no exception leaves it.
#include "tracer/image/module/image_module.h"

#include <cstdio>
#include <exception>
#include <memory>
#include <string>
#include <vector>

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

namespace {

// Files carry no time, so that equal pictures are equal files.
constexpr const char* kDateTime = "2000:01:01 00:00:00";
constexpr int kJpegQuality = 95;
constexpr int kPngCompression = 4;

int refuse(const std::string& why, char* message, size_t capacity) {
    std::snprintf(message, capacity, "%s", why.c_str());
    return 0;
}

OIIO::TypeDesc type_of(unsigned char type) {
    return type == 0 ? OIIO::TypeDesc::UINT8 : type == 1 ? OIIO::TypeDesc::HALF : OIIO::TypeDesc::FLOAT;
}

OIIO::ImageSpec spec_of(const WhittleEncodeJob& job, const std::string& format) {
    OIIO::TypeDesc widest = type_of(job.types[0]);
    OIIO::ImageSpec spec(job.width, job.height, job.channels, widest);
    spec.channelnames.clear();
    bool mixed = false;
    for (int c = 0; c < job.channels; ++c) {
        spec.channelnames.emplace_back(job.names[c]);
        spec.channelformats.push_back(type_of(job.types[c]));
        mixed = mixed || job.types[c] != job.types[0];
        if (spec.channelnames.back() == "A") spec.alpha_channel = c;
    }
    if (!mixed) spec.channelformats.clear();
    spec.attribute("DateTime", kDateTime);
    spec.attribute("Software", "Whittle");
    if (format == "openexr") spec.attribute("compression", "zip");
    if (format == "openexr") spec.attribute("oiio:ColorSpace", "Linear");
    if (format == "tiff") spec.attribute("compression", "zip");
    if (format == "jpeg") spec.attribute("Compression", "jpeg:" + std::to_string(kJpegQuality));
    if (format == "png") spec.attribute("png:compressionLevel", kPngCompression);
    return spec;
}

int encode(const WhittleEncodeJob& job, char* message, size_t capacity) {
    const std::string format = job.format;
    std::unique_ptr<OIIO::ImageOutput> output = OIIO::ImageOutput::create(format);
    if (!output) return refuse("the image library cannot write " + format + ": " + OIIO::geterror(), message, capacity);
    std::vector<unsigned char> memory;
    OIIO::Filesystem::IOVecOutput proxy(memory);
    if (!output->supports("ioproxy") || !output->set_ioproxy(&proxy)) return refuse("the image library cannot write " + format + " to memory", message, capacity);
    if (!output->open("picture." + format, spec_of(job, format))) return refuse(output->geterror(), message, capacity);
    const bool written = job.bytes ? output->write_image(OIIO::TypeDesc::UINT8, job.bytes) : output->write_image(OIIO::TypeDesc::FLOAT, job.floats);
    if (!written || !output->close()) return refuse(output->geterror(), message, capacity);
    if (!job.write(job.sink, memory.data(), memory.size())) return refuse("out of memory", message, capacity);
    return 1;
}

int decode(const WhittleDecodeJob& job, char* message, size_t capacity) {
    std::unique_ptr<OIIO::ImageInput> input = OIIO::ImageInput::open(job.path);
    if (!input) return refuse(OIIO::geterror(), message, capacity);
    const OIIO::ImageSpec& spec = input->spec();
    std::vector<const char*> names;
    for (const std::string& name : spec.channelnames) names.push_back(name.c_str());
    float* room = job.room(job.sink, spec.width, spec.height, spec.nchannels, names.data());
    if (!room) return refuse("out of memory", message, capacity);
    if (!input->read_image(0, 0, 0, -1, OIIO::TypeDesc::FLOAT, room)) return refuse(input->geterror(), message, capacity);
    return 1;
}

template <class Job>
int guarded(int (*work)(const Job&, char*, size_t), const Job* job, char* message, size_t capacity) {
    try {
        return work(*job, message, capacity);
    } catch (const std::exception& e) {
        return refuse(e.what(), message, capacity);
    } catch (...) {
        return refuse("unknown exception in the image library", message, capacity);
    }
}

}  // namespace

extern "C" {

int whittle_image_abi(void) { return WHITTLE_IMAGE_ABI; }
int whittle_image_encode(const WhittleEncodeJob* job, char* message, size_t capacity) { return guarded(&encode, job, message, capacity); }
int whittle_image_decode(const WhittleDecodeJob* job, char* message, size_t capacity) { return guarded(&decode, job, message, capacity); }
}
