#include "tests/support/pdf_pictures.h"

#include <sstream>
#include <stdexcept>
#include <string>

#include "tests/support/process.h"

namespace leitstand::test {

std::vector<PdfPicture> pdfPictures(const std::filesystem::path& file) {
    const ProcessOutcome list = runProcess("/usr/bin/pdfimages", {"-list", file.string()});
    if (list.exitCode != 0) throw std::runtime_error("pdfimages fails (poppler-utils): " + list.err);
    std::vector<PdfPicture> pictures;
    std::istringstream lines(list.out);
    std::string line;
    for (int number = 0; std::getline(lines, line); ++number) {
        std::istringstream fields(line);
        std::string image, type, colour, components, bits, encoding, smooth, object, generation;
        PdfPicture one;
        if (number >= 2 &&
            fields >> one.page >> image >> type >> one.width >> one.height >> colour >> components >> bits >>
                encoding >> smooth >> object >> generation >> one.acrossPerInch >> one.downPerInch &&
            type == "image")
            pictures.push_back(one);
    }
    return pictures;
}

}  // namespace leitstand::test
