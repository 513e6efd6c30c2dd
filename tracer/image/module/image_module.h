/* image_module.h — the plain C interface between the program and the image module it opens when first needed. */
#ifndef WHITTLE_IMAGE_MODULE_H
#define WHITTLE_IMAGE_MODULE_H

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

#define WHITTLE_IMAGE_ABI 1

/* Takes `size` bytes; returns 0 when it could not. */
typedef int (*WhittleSink)(void* sink, const void* data, size_t size);
/* Returns room for width*height*channels floats and is told the channels' names; null when it could not. */
typedef float* (*WhittleRoom)(void* sink, int width, int height, int channels, const char* const* names);

typedef struct {
    const char* format; /* "png", "jpeg", "openexr", "tiff" */
    int width, height, channels;
    const char* const* names;
    const unsigned char* types;   /* a channel: 0 byte, 1 half, 2 float */
    const unsigned char* bytes;   /* either these, interleaved, */
    const float* floats;          /* or these */
    void* sink;
    WhittleSink write;
} WhittleEncodeJob;

typedef struct {
    const char* path;
    void* sink;
    WhittleRoom room;
} WhittleDecodeJob;

/* Both return 1 on success, else 0 and a sentence in `message`. */
typedef int (*WhittleEncode)(const WhittleEncodeJob* job, char* message, size_t capacity);
typedef int (*WhittleDecode)(const WhittleDecodeJob* job, char* message, size_t capacity);

/* The module's symbols: whittle_image_abi, whittle_image_encode, whittle_image_decode. */
int whittle_image_abi(void);
int whittle_image_encode(const WhittleEncodeJob* job, char* message, size_t capacity);
int whittle_image_decode(const WhittleDecodeJob* job, char* message, size_t capacity);

#ifdef __cplusplus
}
#endif

#endif
