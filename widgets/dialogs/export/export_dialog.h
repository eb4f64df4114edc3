/// \file
/// The export dialog: what to export, how, and where to.
#pragma once

#include "core/qt/session/export/export_options.h"
#include "widgets/dialogs/export/export_uses.h"
#include "widgets/dialogs/export/sequence_task.h"
#include <QDialog>
#include <QVariantMap>
#include <functional>
#include <map>
#include <optional>
#include <vector>

class QCheckBox;
class QComboBox;
class QGridLayout;
class QLabel;
class QLayout;
class QLineEdit;
class QProgressBar;
class QPushButton;
class QScrollArea;
class QTabBar;
class QVBoxLayout;

namespace ramure {

class Analysis;
class Chooser;
class Document;
class ExportTask;
class FaultsLine;
class KeptForm;
class LevelForm;
class MomentForm;
class OptionFields;
class PartsForm;
class PictureForm;
class Preferences;
class PrintForm;
class PrintPreparer;
class Recompute;

class ExportDialog : public QDialog
{
    Q_OBJECT
public:
    /// Nothing is owned; all must outlive the dialog. \param shownFrame of the timeline.
    ExportDialog(Document* document, Recompute* recompute, Preferences* preferences, Chooser* chooser,
                 QWidget* parent = nullptr, std::int64_t shownFrame = 0);
    ~ExportDialog() override;

    /// Sets the analysis whose findings are told before a mesh that is not clean is written. Without it only
    /// defects are told.
    void setAnalysis(const Analysis* analysis);
    /// Sets the task that writes sequences in the background. Without it the dialog offers none. Not owned.
    void setSequenceTask(SequenceTask* task);
    /// How pictures look; without it there are none.
    void setPictureLook(const PictureLook& look);
    /// The page on show.
    void setUse(ExportUse use);
    [[nodiscard]] ExportUse use() const { return m_use; }
    /// Turns to the page for games, which has them.
    void setLevels(const LevelOptions& levels);
    /// Offers these levels when the page for games is opened, instead of those of an earlier export.
    void offerLevels(const LevelOptions& levels);
    /// There is a view that shows it: windShown().
    void offerWind();
    /// FileFormat::id, or "png": pictures of the view. Turns to a page that has it.
    void setFormat(const QString& id);
    /// All that was chosen, but where to; and the same again. Numbers out of range are brought into it.
    [[nodiscard]] QVariantMap settings() const;
    void setSettings(const QVariantMap& kept);
    /// Starts the same export again, over the files that it wrote.
    void repeat(const QVariantMap& settings, const QString& path);
    [[nodiscard]] MomentForm* moments() const { return m_moments; }
    [[nodiscard]] PictureForm* pictures() const { return m_pictures; }
    [[nodiscard]] PrintForm* printing() const { return m_print.form; }
    void setPath(const QString& path);
    [[nodiscard]] QString path() const;
    [[nodiscard]] ExportOptions options() const;
    /// Waits for the full result if it is being computed, then writes on a thread.
    void startExport();

signals:
    /// The file was written, and the dialog has closed itself.
    void exported(const QString& path);
    /// A sequence, or a picture, is being written by the task; the dialog has closed itself.
    void started();
    /// Asks to show the problems of this tree's mesh; the dialog has closed itself.
    void showRequested(ramure::NodeId tree);
    /// Trees in the view are to move as they will in that engine; None: not any more.
    void windShown(ramure::WindProfile game);

public slots:
    void reject() override;         ///< cancels a running job first
    void done(int result) override; ///< also keeps the settings of each page for the next time

protected:
    void showEvent(QShowEvent* event) override;

private:
    /// Adds a row below the others.
    void addRow(const QString& text, QWidget* field, std::function<bool(const ExportPage&)> isShown = {});
    void addRow(const ExportOption& option, QWidget* field); ///< shown where the option is offered
    void buildForm();
    void addRows();
    [[nodiscard]] QLayout* buildWind();
    void buildUses(QVBoxLayout* layout);
    void fillFormats();
    void takeUse(int tab);
    [[nodiscard]] QLayout* buildSpace();
    [[nodiscard]] QLayout* buildScope();
    [[nodiscard]] QLayout* buildTarget();
    void buildProgress(QVBoxLayout* layout);
    void connectForms();
    void showFaults();
    [[nodiscard]] bool mayExportFaults();
    void browse();
    void takeFormat();
    [[nodiscard]] ExportPage page() const; ///< on show
    void showRows(const ExportPage& page);
    [[nodiscard]] QSize pageHint() const;
    [[nodiscard]] QSize roomForPages();
    void makeRoom(const QSize& page);
    void updateWidgets();
    void setFormatTexts();
    void connectMessage();
    void keepChoices();
    void run();
    // export_sequence.cpp
    void updateSummary();
    [[nodiscard]] bool isClip() const;
    [[nodiscard]] bool isFilmed() const;
    [[nodiscard]] bool isNumbered() const; ///< a file for each frame
    [[nodiscard]] bool isInBackground() const;
    [[nodiscard]] bool mayStart();
    [[nodiscard]] bool mayReplaceFiles();
    void startSequence();
    // export_kept.cpp
    void turnPage(ExportUse use);
    void keepPages();
    [[nodiscard]] bool isPrint() const;
    void connectPrint();
    void takePrint(const std::optional<Error>& error);
    void writePrint();
    void finish(const std::optional<Error>& error);
    void setProgress(double fraction);
    void setMessage(const QString& text, bool isError);
    /// Null: pictures.
    [[nodiscard]] const FileFormat* format() const;
    [[nodiscard]] bool holds(int what) const; ///< bits of FormatHolds
    void setPicturesEnabled(bool enabled);
    [[nodiscard]] QString suffix() const;

    Document* m_document;
    Recompute* m_recompute;
    Preferences* m_preferences;
    Chooser* m_chooser;
    ExportTask* m_task;
    bool m_waiting = false;
    FaultsLine* m_faults = nullptr;
    struct
    {
        QString path;     ///< the path (and frames) whose existing files the user has agreed to overwrite
        bool all = false; ///< the export is repeated
    } m_mayReplace;
    ExportUse m_use = ExportUse::Blender;
    QVariantMap m_usual;                      ///< settings before anybody chose
    std::map<ExportUse, QVariantMap> m_pages; ///< settings of the pages that were left
    QTabBar* m_uses = nullptr;
    QScrollArea* m_scroll = nullptr;
    QWidget* m_page = nullptr; ///< the form, which is scrolled
    struct FormRow
    {
        QLabel* label;
        QWidget* field;
        std::function<bool(const ExportPage&)> isShown; ///< empty: always
    };
    QGridLayout* m_form = nullptr;
    std::vector<FormRow> m_rows;
    OptionFields* m_fields; ///< fields of the table of options
    KeptForm* m_kept = nullptr;
    LevelForm* m_levels = nullptr;
    std::optional<LevelOptions> m_offered;
    QPushButton* m_showWind = nullptr; ///< while it is down
    QComboBox* m_format = nullptr;
    PartsForm* m_parts = nullptr;
    QCheckBox* m_selection = nullptr;
    QCheckBox* m_hidden = nullptr;
    QLineEdit* m_path = nullptr;
    QPushButton* m_browse = nullptr;
    SequenceTask* m_sequences = nullptr;
    std::optional<PictureLook> m_look;
    MomentForm* m_moments = nullptr;
    PictureForm* m_pictures = nullptr;
    struct
    {
        PrintForm* form = nullptr;
        PrintPreparer* preparer = nullptr;
        bool isAwaited = false; ///< it is written as soon as it is there
    } m_print;
    QLabel* m_summary = nullptr;
    std::int64_t m_shownFrame;
    QProgressBar* m_progress = nullptr;
    QLabel* m_message = nullptr;
    QPushButton* m_export = nullptr;
};

} // namespace ramure
