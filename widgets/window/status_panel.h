/// \file
/// The right end of the status bar: progress with cancel, counts, build time, and what the meshes are worth.
#pragma once

#include "core/qt/document/document.h"
#include "core/qt/session/export/scene_counts.h"
#include "core/surface/check/verdict.h"
#include <QWidget>

class QLabel;
class QProgressBar;
class QTimer;
class QToolButton;

namespace ramure {

class Analysis;
class Player;
class Recompute;

/// What the status bar tells of all trees of the scene.
struct SceneTotals
{
    Index trees = 0, results = 0;
    quint64 branches = 0; ///< of those that are shown
    double seconds = 0.0;
    bool draft = false;
    bool failed = false;                      ///< a tree has an error
    MeshVerdict verdict = MeshVerdict::Clean; ///< the worst
    quint64 crossings = 0;                    ///< pairs of triangles
    /// By the tree's name; none is null.
    std::vector<std::pair<QString, std::shared_ptr<const MeshReport>>> reports;
};
/// \param analysis null: crossings have not been looked for.
SceneTotals sceneTotals(const Document& document, const Analysis* analysis);

class StatusPanel : public QWidget
{
    Q_OBJECT
public:
    /// None is owned; all must outlive the panel. Without an analysis no hash is shown.
    StatusPanel(Document* document, Recompute* recompute, QWidget* parent = nullptr);
    StatusPanel(Document* document, Recompute* recompute, Analysis* analysis, QWidget* parent = nullptr);

    /// Also what it computes that takes long: trees whose shape has keys. It must outlive the panel.
    void follow(Player* player);

    /// The picture of a bark is being made: that is told, unless it is quick.
    void setMakesBark(bool makes);

    [[nodiscard]] QString countsText() const;
    /// How long the trees took; a word where nothing had to be computed.
    [[nodiscard]] static QString timeText(double seconds);
    [[nodiscard]] QString hashText() const;
    /// "good", "bad", "busy", or "closed" where crossings have not been looked for, or do not matter.
    [[nodiscard]] QString badgeState() const;

signals:
    /// The badge was clicked: what the meshes are worth is asked for in full.
    void reportRequested();

protected:
    void changeEvent(QEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;
    void showEvent(QShowEvent* event) override;

private:
    void follow();
    void update();
    void showCounts(const SceneTotals& totals);
    [[nodiscard]] static QString countsTip(const SceneCounts& counts);
    void showBadge(const SceneTotals& totals);
    void setBadge(const QString& state, const QString& text, const QString& tip);
    void showBusy();
    [[nodiscard]] bool isBusy() const;
    void showHash();
    void measureAnew();
    void fitWindow();
    [[nodiscard]] QString reportTip(const SceneTotals& totals) const;

    Document* m_document;
    Recompute* m_recompute;
    Player* m_player = nullptr;
    Analysis* m_analysis;
    QProgressBar* m_progress;
    QToolButton* m_cancel;
    QLabel* m_bark;
    QLabel* m_counts;
    QLabel* m_time;
    QLabel* m_hash;
    QLabel* m_badge;
    QTimer* m_patience; ///< short work shows no progress
    QTimer* m_barkPatience;
    SceneCounter m_counter;
};

} // namespace ramure
