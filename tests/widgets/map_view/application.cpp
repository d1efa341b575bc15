#include <memory>

#include <gtest/gtest.h>
#include <QApplication>
#include <QFont>

namespace leitstand::test {
namespace {

/// Gives all tests of this program one application without a display.
class Application final : public testing::Environment {
public:
    void SetUp() override {
        if (qEnvironmentVariableIsEmpty("QT_QPA_PLATFORM")) qputenv("QT_QPA_PLATFORM", "offscreen");
        // Mesa's software renderer would otherwise take every core from the GUI thread that is measured.
        if (qEnvironmentVariableIsEmpty("LP_NUM_THREADS")) qputenv("LP_NUM_THREADS", "1");
        m_application = std::make_unique<QApplication>(m_argumentCount, m_arguments);
        QFont font(QStringLiteral("DejaVu Sans"));
        font.setPixelSize(13);
        QApplication::setFont(font);
    }
    void TearDown() override { m_application.reset(); }

private:
    int m_argumentCount = 1;
    char m_name[12] = "image_tests";
    char* m_arguments[2] = {m_name, nullptr};
    std::unique_ptr<QApplication> m_application;
};

const auto* const TheApplication = testing::AddGlobalTestEnvironment(new Application);

}  // namespace
}  // namespace leitstand::test
