#pragma once

#include <filesystem>
#include <vector>

namespace leitstand::test {

/// A picture of a PDF, as pdfimages lists it.
struct PdfPicture {
    int page = 0;
    int width = 0, height = 0;               ///< [px]
    int acrossPerInch = 0, downPerInch = 0;  ///< as it is printed [px]
};

/// The pictures of @p file, without masks; throws where pdfimages is missing or fails.
[[nodiscard]] std::vector<PdfPicture> pdfPictures(const std::filesystem::path& file);

}  // namespace leitstand::test
