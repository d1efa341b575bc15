#include "tests/app/window/review_page.h"

#include <algorithm>
#include <filesystem>
#include <string>

#include <QAction>
#include <QFileDialog>
#include <QLabel>
#include <QTableView>
#include <QToolButton>

#include "app/window/commands/command_table.h"
#include "app/window/layouts/layout_feature.h"
#include "app/window/source/review_report.h"
#include "tests/app/report/sample_mission.h"
#include "tests/support/pdf_pictures.h"
#include "widgets/models/message_list_model.h"

namespace leitstand::test {
namespace {

namespace fs = std::filesystem;

/// The hand-in of a reviewed mission.
class ReviewReportTest : public ReviewPage {
protected:
    /// Asks for it by the button, and chooses @p name in the dialog, which the platform may draw.
    void report(const char* name) {
        find<QToolButton>("review.report").click();
        auto& dialog = find<QFileDialog>("reportFolder");
        EXPECT_FALSE(dialog.isModal());
        const QString folder = QString::fromStdString((m_folder / name).string());
        emit dialog.fileSelected(folder);
        delete &dialog;
        ASSERT_TRUE(soon([&] { return m_window->newest().contains("written into " + folder) && !busy(); }))
            << m_window->newest().toStdString();
    }
    [[nodiscard]] bool busy() const { return m_bridge->report().writing(); }
    /// What the pane of messages lists.
    [[nodiscard]] QString messages() const {
        const MessageListModel& list = m_bridge->messages();
        QStringList all;
        for (int row = 0; row < list.rowCount(); ++row) all.append(list.index(row).data().toString());
        return all.join(QLatin1Char('\n'));
    }
    /// The list of victims of the hand-in @p name.
    [[nodiscard]] std::string victims(const char* name) const {
        const fs::path list = fileOf(name, "_victims.csv");
        return list.empty() ? "there is no list" : readText(list);
    }
    /// The file of the hand-in @p name that ends so; empty where there is none.
    [[nodiscard]] fs::path fileOf(const char* name, const char* ending) const {
        for (const fs::directory_entry& one : fs::directory_iterator(m_folder / name)) {
            if (one.path().filename().string().ends_with(ending)) return one.path();
        }
        return {};
    }
};

TEST_F(ReviewReportTest, TheButtonWritesTheJudgesFolderWithWhatWasCorrectedInTheReview) {
    goTo(47.0);
    ASSERT_TRUE(m_window->layouts().use(QStringLiteral("report"))) << m_window->newest().toStdString();
    auto& button = find<QToolButton>("review.report");
    ASSERT_TRUE(soon([&] { return !button.visibleRegion().isEmpty(); }));
    EXPECT_EQ(m_window->commands().find("review.report")->shortcut(),
              QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_J))
        << "as in the live window";
    ASSERT_NO_FATAL_FAILURE(report("before"));
    EXPECT_TRUE(messages().contains("competition or team are not given")) << messages().toStdString();
    EXPECT_TRUE(fs::exists(m_folder / "before" / "SHA256SUMS"));
    EXPECT_NE(victims("before").find("V1"), std::string::npos) << victims("before");
    EXPECT_EQ(button.text().toStdString(), "Report");
    EXPECT_TRUE(button.isEnabled());

    m_window->commands().trigger(QStringLiteral("review.finished"));
    ASSERT_TRUE(soon([&] { return finds() == 1; }));
    find<QTableView>("finds").selectRow(0);
    find<QToolButton>("review.discard").click();
    ASSERT_NO_FATAL_FAILURE(report("after"));  // at once: what was written goes before
    EXPECT_TRUE(fs::exists(m_folder / "after" / "SHA256SUMS"));
    EXPECT_EQ(victims("after").find("V1"), std::string::npos) << victims("after");
}

/// A mission whose victim has pictures of two cameras and a scan as evidence.
class ReviewReportOfEvidence : public ReviewReportTest {
    void writeMission() override { writeSampleMission(m_mission); }
};

TEST_F(ReviewReportOfEvidence, ItsPicturesHaveTheShapeOfWhatTheyShow) {
    ASSERT_NO_FATAL_FAILURE(report("out"));
    const auto pictures = pdfPictures(fileOf("out", ".pdf"));
    for (const int width : {80, 160, 560}) {
        EXPECT_TRUE(std::any_of(pictures.begin(), pictures.end(),
                                [&](const PdfPicture& one) { return one.width == width; }))
            << "of infrared, camera and scan: " << width;
    }
    for (const PdfPicture& one : pictures)
        EXPECT_NEAR(one.acrossPerInch, one.downPerInch, 1) << one.width << " x " << one.height;
}

TEST_F(ReviewReportTest, ItsScoreIsThatOfTheMomentThatIsShown) {
    goTo(10.0);
    ASSERT_TRUE(m_window->layouts().use(QStringLiteral("report"))) << m_window->newest().toStdString();
    const auto& pane = find<QWidget>("scorePane");
    const auto says = [&](const char* words) {
        const auto labels = pane.findChildren<QLabel*>();
        return std::any_of(labels.begin(), labels.end(),
                           [&](const QLabel* one) { return one->text().contains(QLatin1String(words)); });
    };
    ASSERT_TRUE(soon([&] { return says("points"); }));
    EXPECT_FALSE(says("V1"));
    goTo(47.0);
    EXPECT_TRUE(soon([&] { return says("V1"); })) << "it was found by then";
    goTo(10.0);
    EXPECT_TRUE(soon([&] { return !says("V1"); }));
}

}  // namespace
}  // namespace leitstand::test
