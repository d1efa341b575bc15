#pragma once

#include <chrono>
#include <memory>

#include <QObject>
#include <QString>

#include "app/services/preflight/preflight_desk.h"
#include "app/window/panes/view_context.h"

class QDialog;
class QLabel;

namespace leitstand {

struct LiveMoment;
class PreflightPage;

/// The preflight page (F9): what is in order and what is not, brake tests, adding robots.
class PreflightFeature final : public QObject {
    Q_OBJECT
public:
    explicit PreflightFeature(const LiveContext& context);

    /// Returns the badge for the corner. It names robots that are driven although they failed their brake
    /// test.
    [[nodiscard]] QLabel& badge() const { return *m_badge; }

    /// Opens the page after 8 s if a check fails then and nobody drives.
    void openWhenSomethingFails();
    void setGamepad(const QString& name);      ///< empty: there is none
    void setSoundTrouble(const QString& why);  ///< empty: tones of alarms can be heard

signals:
    void robotWanted(const QString& file);  ///< the station shall add the robot in this file
    void tonesWanted();                     ///< the tones of alarms shall be played as a test

private:
    void buildPage();
    void open();
    [[nodiscard]] PreflightFacts facts() const;
    void refresh();
    void show(const LiveMoment& moment);
    void add(const QString& stranger);
    void addFile();
    void join(const QString& file);
    void showOverrides();

    LiveContext m_context;
    PreflightDesk m_desk;
    QDialog* m_dialog;
    PreflightPage* m_page;
    QLabel* m_badge;
    QString m_gamepad, m_soundTrouble;
    std::chrono::steady_clock::time_point m_shown = {};
};

}  // namespace leitstand
