#include "core/base/words.h"

#include <atomic>

namespace leitstand {
namespace {

std::atomic<Translator> inUse = nullptr;

}  // namespace

void setTranslator(Translator translator) {
    inUse = translator;
}

std::string translate(const char* context, const char* text) {
    const Translator translator = inUse;
    return translator == nullptr ? text : translator(context, text);
}

}  // namespace leitstand
