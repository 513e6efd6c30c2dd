#include "csg/eval/large_stack.h"

#include <pthread.h>

namespace whittle {
namespace {

void* run(void* argument) {
    (*static_cast<const std::function<void()>*>(argument))();
    return nullptr;
}

}  // namespace

bool run_on_large_stack(const std::function<void()>& work) {
    pthread_attr_t attributes;
    if (pthread_attr_init(&attributes) != 0) return false;
    pthread_t thread;
    const bool started = pthread_attr_setstacksize(&attributes, kLargeStackBytes) == 0 &&
                         pthread_create(&thread, &attributes, run, const_cast<void*>(static_cast<const void*>(&work))) == 0;
    pthread_attr_destroy(&attributes);
    if (started) pthread_join(thread, nullptr);
    return started;
}

}  // namespace whittle
