#include "core/qt/session/motion/baker.h"

#include "core/params/source_facts.h"
#include "core/qt/base/system_path.h"
#include "core/qt/session/export/document_source.h"
#include "core/qt/session/export/exporter.h"
#include "core/rig/physics/physics_bake.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QRegularExpression>
#include <algorithm>

namespace ramure {
namespace {

struct BakedTree
{
    TreeResult tree;
    double alpha = 0.0;
    PhysicsParams params;
    std::string file;
};

tl::unexpected<Error> refuse(const std::string& file, ErrorCode code, const char* text,
                             std::vector<std::string> args = {})
{
    auto error = fail(code, text, std::move(args));
    error.value().file = file;
    return error;
}

Expected<std::vector<BakedTree>> bakedTrees(const Document& document)
{
    const TreeSource source = documentSource(document);
    std::vector<BakedTree> trees;
    for (const Node& node : document.scene().nodes()) {
        if (node.kind != NodeKind::Tree || !document.scene().isShown(node.id))
            continue;
        auto result = source(node, Stage::Foliage, {});
        RAMURE_TRY(result);
        BakedTree tree{std::move(*result), trunkRadius(node.params), node.params.physics,
                       systemPath(bakeFile(document.filePath(), node.id))};
        if (QFileInfo::exists(bakeFile(document.filePath(), node.id)) && !isBakeFile(tree.file))
            return refuse(tree.file, ErrorCode::Invalid,
                          RAMURE_NOOP("a file of this name is there that is no baked motion: it stays"));
        trees.push_back(std::move(tree));
    }
    if (trees.empty())
        return fail(ErrorCode::Invalid, RAMURE_NOOP("there is no visible tree to bake"));
    return trees;
}

Expected<void> bakeAll(const std::vector<BakedTree>& trees, double seconds, std::size_t memoryBytes,
                       const Progress& progress)
{
    const auto count = static_cast<double>(trees.size());
    for (std::size_t i = 0; i < trees.size(); ++i) {
        const BakedTree& tree = trees[i];
        PhysicsCacheOptions options;
        options.memoryBytes = memoryBytes / trees.size();
        PhysicsCache cache(makeTreeBody(tree.tree.simplified->skeleton, tree.tree.foliage.get(), tree.alpha),
                           tree.params, options);
        const double from = static_cast<double>(i) / count;
        if (auto saved =
                saveBake(cache, cache.stepAt(seconds), tree.file, progress.part(from, from + 1.0 / count));
            !saved)
            return saved;
    }
    return {};
}

} // namespace

QString bakeFile(const QString& project, NodeId tree)
{
    if (project.isEmpty())
        return {};
    const QFileInfo info(project);
    return info.dir().filePath(info.completeBaseName() + QStringLiteral(".motion-%1.bake").arg(tree));
}

QStringList bakeFiles(const QString& project)
{
    if (project.isEmpty())
        return {};
    const QFileInfo info(project);
    const QRegularExpression name(QStringLiteral("^%1\\.motion-[0-9]+\\.bake$")
                                      .arg(QRegularExpression::escape(info.completeBaseName())));
    QStringList found;
    for (const QString& file : info.dir().entryList(QDir::Files | QDir::Hidden, QDir::Name))
        if (name.match(file).hasMatch())
            found.push_back(info.dir().filePath(file));
    return found;
}

Baker::Baker(const Document* document, QObject* parent)
    : QObject(parent)
    , m_document(document)
{
    connect(&m_job, &Job::finished, this, &Baker::filesChanged);
}

Expected<void> Baker::start(std::size_t memoryBytes)
{
    if (m_document->filePath().isEmpty())
        return fail(ErrorCode::Invalid, RAMURE_NOOP("baked motion lies beside the project: save that first"));
    const TimelineSettings& timeline = m_document->scene().timeline();
    const double seconds = timeline.timeOf(timeline.lastFrame);
    if (seconds <= 0.0)
        return fail(ErrorCode::Invalid, RAMURE_NOOP("the range ends at frame 0 or before, where trees rest"));
    if (m_job.isRunning())
        return {};
    auto trees = bakedTrees(*m_document);
    RAMURE_TRY(trees);
    m_job.start([trees = std::move(*trees), seconds, memoryBytes](const Progress& progress) {
        return bakeAll(trees, seconds, memoryBytes, progress);
    });
    return {};
}

Expected<void> Baker::remove()
{
    m_job.cancel();
    std::optional<Error> problem;
    for (const QString& path : bakeFiles(m_document->filePath())) {
        QFile file(path);
        if (!isBakeFile(systemPath(path)))
            problem = refuse(systemPath(path), ErrorCode::Invalid,
                             RAMURE_NOOP("a file of this name is there that is no baked motion: it stays"))
                          .value();
        else if (!file.remove())
            problem = refuse(systemPath(path), ErrorCode::Io, RAMURE_NOOP("cannot be deleted: %1"),
                             {file.errorString().toStdString()})
                          .value();
    }
    emit filesChanged();
    return problem ? fail(std::move(*problem)) : Expected<void>();
}

qint64 Baker::bytes() const
{
    qint64 sum = 0;
    for (const QString& path : bakeFiles(m_document->filePath()))
        sum += QFileInfo(path).size();
    return sum;
}

} // namespace ramure

#include "moc_baker.cpp"
