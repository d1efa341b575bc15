#include <string>

#include "core/base/phrases/coded_text.h"
#include "core/base/printable.h"
#include "core/io/handin/csv_fields.h"
#include "fuzz/input_file.h"

/// Names that others chose, on their way to a terminal and into lists.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace leitstand;
    const std::string text(reinterpret_cast<const char*>(data), size);
    const std::string shown = printable(text);
    for (const char byte : shown) {
        const auto value = static_cast<unsigned char>(byte);
        fuzz::require(value >= 0x20 && value != 0x7f, "nothing that a terminal obeys");
    }
    fuzz::require(printable(shown) == shown, "what is printable stays as it is");
    const std::string field = quotedField(text);
    fuzz::require(field.size() >= 2 && field.find('\n') == std::string::npos, "a record on one line");
    fuzz::require(field[1] != '=' && field[1] != '@' && field[1] != '\t', "a field that begins no formula");
    // Texts of a log, which another program may have written.
    if (const auto coded = codedText(text)) {
        const auto again = codedText(toString(*coded));
        fuzz::require(again && again->code == coded->code && again->values == coded->values,
                      "codes come back");
    }
    return 0;
}
