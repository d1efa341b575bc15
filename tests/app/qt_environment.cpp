#include <memory>

#include <QApplication>
#include <QEvent>
#include <QLocale>

#include <gtest/gtest.h>

namespace leitstand::test {
namespace {

/// One application for all tests of the process, without a display.
class QtEnvironment final : public testing::Environment {
public:
    void SetUp() override {
        if (qEnvironmentVariableIsEmpty("QT_QPA_PLATFORM")) qputenv("QT_QPA_PLATFORM", "offscreen");
        static int argc = 1;
        static char name[] = "leitstand-tests";
        static char* argv[] = {name, nullptr};
        m_application = std::make_unique<QApplication>(argc, argv);
        QLocale::setDefault(QLocale(QLocale::English, QLocale::UnitedStates));
    }
    void TearDown() override {
        // As the end of QApplication::exec() does: a window that draws while the process ends would crash.
        QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
        m_application.reset();
    }

private:
    std::unique_ptr<QApplication> m_application;
};

[[maybe_unused]] const auto* const environment = testing::AddGlobalTestEnvironment(new QtEnvironment);

}  // namespace
}  // namespace leitstand::test
