<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="ja" sourcelanguage="en">
<context>
    <name>ChangesText</name>
    <message>
        <source>this mission</source>
        <translation>このミッション</translation>
    </message>
    <message>
        <source>new</source>
        <translation>新規</translation>
    </message>
    <message>
        <source>gone</source>
        <translation>消失</translation>
    </message>
    <message>
        <source>%1 × %2 × %3 m</source>
        <translation>%1 × %2 × %3 m</translation>
    </message>
    <message>
        <source>x %1, y %2, z %3 m</source>
        <translation>x %1, y %2, z %3 m</translation>
    </message>
    <message>
        <source>What changed</source>
        <translation>変化したもの</translation>
    </message>
    <message>
        <source>Between %1 and %2: %3 came, %4 went. Listed is what one visit&apos;s scans have where the other&apos;s looked through; what was not looked at both times is not compared.</source>
        <translation>%1と%2の間: 増えたもの%3、なくなったもの%4。一方のスキャンが素通しで見た所に他方のスキャンが捉えたものを示します。両方で見ていない所は比較していません。</translation>
    </message>
    <message>
        <source>What</source>
        <translation>種類</translation>
    </message>
    <message>
        <source>Size, along x, y and z</source>
        <translation>大きさ（x, y, z方向）</translation>
    </message>
    <message>
        <source>Middle, and its lowest z</source>
        <translation>中心と最低のz</translation>
    </message>
    <message>
        <source>and %1 smaller ones</source>
        <translation>ほか小さいもの%1</translation>
    </message>
</context>
<context>
    <name>CoverageText</name>
    <message>
        <source>Camera</source>
        <translation>カメラ</translation>
    </message>
    <message>
        <source>Infrared</source>
        <translation>赤外線</translation>
    </message>
    <message>
        <source>Scanner</source>
        <translation>スキャナ</translation>
    </message>
    <message>
        <source>nothing</source>
        <translation>なし</translation>
    </message>
    <message>
        <source>%1 m² at x %2, y %3</source>
        <translation>x %2、y %3 に %1 m²</translation>
    </message>
    <message>
        <source>and %1 more</source>
        <translation>ほか %1 件</translation>
    </message>
    <message>
        <source>Searched</source>
        <translation>探索済み</translation>
    </message>
    <message>
        <source>Of %1 m² of floor that the robots can reach. Seen is where a body on the floor would span enough pixels or points.</source>
        <translation>ロボットが到達できる床 %1 m² のうち。床の人体が十分な画素または点数で写る所を「見た」とする。</translation>
    </message>
    <message>
        <source>Sensor</source>
        <translation>センサー</translation>
    </message>
    <message>
        <source>Seen</source>
        <translation>見た</translation>
    </message>
    <message>
        <source>Missed, the largest first</source>
        <translation>見落とし、大きい順</translation>
    </message>
    <message>
        <source>%1 m², %2 %</source>
        <translation>%1 m²、%2 %</translation>
    </message>
    <message>
        <source>%1 m² at x %2, y %3, storey %4</source>
        <translation>%1 m²（x %2、y %3、%4階）</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>Storey</source>
        <translation>階</translation>
    </message>
    <message>
        <source>Can be reached</source>
        <translation>到達可能</translation>
    </message>
    <message>
        <source>%1 m²</source>
        <translation>%1 m²</translation>
    </message>
</context>
<context>
    <name>CurveText</name>
    <message>
        <source>CO₂ measured by %1</source>
        <translation>%1 が測定した CO₂</translation>
    </message>
    <message>
        <source>CO₂ [ppm]</source>
        <translation>CO₂ [ppm]</translation>
    </message>
    <message>
        <source>time of day</source>
        <translation>時刻</translation>
    </message>
</context>
<context>
    <name>EvidenceText</name>
    <message>
        <source>, 15 to 40 °C, hottest %1 °C</source>
        <translation>、15～40 °C、最高 %1 °C</translation>
    </message>
    <message>
        <source>scan of %1, %2, from above: the disc is the find, the arrow the robot; yellow is high; lines are 1 m apart</source>
        <translation>%1 のスキャン、%2、上から:円は発見物、矢印はロボット、黄色は高所、線は 1 m 間隔</translation>
    </message>
    <message>
        <source>scan %1 of %2 at %3, %4 points</source>
        <translation>%2 のスキャン %1、%3、%4 点</translation>
    </message>
    <message>
        <source>scan of %1 at %2, %3 points</source>
        <translation>%1 のスキャン、%2、%3 点</translation>
    </message>
    <message>
        <source>%1 stood at x %2, y %3 m, heading %4° in the map, at %5</source>
        <translation>%1 の地図上の位置 x %2、y %3 m、方位 %4°、%5</translation>
    </message>
    <message>
        <source>%1 stood at x %2, y %3 m of its odometry, heading %4°, at %5: its place in the map is not known</source>
        <translation>%1 のオドメトリ上の位置 x %2、y %3 m、方位 %4°、%5:地図上の位置は不明</translation>
    </message>
    <message>
        <source>CO₂ %1 ppm at %2 (%3)</source>
        <translation>CO₂ %1 ppm、%2(%3)</translation>
    </message>
    <message>
        <source>more pictures, in the mission: %1</source>
        <translation>ほかの画像(ミッション内): %1</translation>
    </message>
</context>
<context>
    <name>Panes</name>
    <message>
        <source>Robot</source>
        <translation>ロボット</translation>
    </message>
    <message>
        <source>Camera</source>
        <translation>カメラ</translation>
    </message>
    <message>
        <source>Second camera</source>
        <translation>第 2 カメラ</translation>
    </message>
    <message>
        <source>3D map</source>
        <translation>3D 地図</translation>
    </message>
    <message>
        <source>Scans and decisions</source>
        <translation>スキャンと判断</translation>
    </message>
    <message>
        <source>Missed</source>
        <translation>見落とし</translation>
    </message>
    <message>
        <source>Changed</source>
        <translation>変化</translation>
    </message>
    <message>
        <source>Virtual scan</source>
        <translation>仮想スキャン</translation>
    </message>
    <message>
        <source>Victims</source>
        <translation>被災者</translation>
    </message>
    <message>
        <source>Finds</source>
        <translation>発見</translation>
    </message>
    <message>
        <source>Form</source>
        <translation>フォーム</translation>
    </message>
    <message>
        <source>Score</source>
        <translation>得点</translation>
    </message>
    <message>
        <source>Link</source>
        <translation>通信</translation>
    </message>
    <message>
        <source>Alarms</source>
        <translation>警報</translation>
    </message>
    <message>
        <source>Compare</source>
        <translation>比較</translation>
    </message>
    <message>
        <source>Messages</source>
        <translation>メッセージ</translation>
    </message>
    <message>
        <source>Flippers and arm</source>
        <translation>フリッパーとアーム</translation>
    </message>
    <message>
        <source>Topics</source>
        <translation>トピック</translation>
    </message>
    <message>
        <source>Readings</source>
        <translation>測定値</translation>
    </message>
    <message>
        <source>Frames</source>
        <translation>座標系</translation>
    </message>
</context>
<context>
    <name>PdfText</name>
    <message>
        <source>page %1</source>
        <translation>%1 ページ</translation>
    </message>
    <message>
        <source>x is up, y is left; lines of the grid are 0.5 m apart</source>
        <translation>x は上、y は左。グリッド間隔 0.5 m</translation>
    </message>
</context>
<context>
    <name>ReportText</name>
    <message>
        <source>confirmed</source>
        <translation>確定</translation>
    </message>
    <message>
        <source>not confirmed</source>
        <translation>未確定</translation>
    </message>
    <message>
        <source>A (autonomous)</source>
        <translation>A（自律）</translation>
    </message>
    <message>
        <source>T (teleoperated)</source>
        <translation>T（遠隔操作）</translation>
    </message>
    <message>
        <source>Victim</source>
        <translation>被災者</translation>
    </message>
    <message>
        <source>Hazard</source>
        <translation>危険物</translation>
    </message>
    <message>
        <source>QR code</source>
        <translation>QRコード</translation>
    </message>
    <message>
        <source>Object of interest</source>
        <translation>対象物</translation>
    </message>
    <message>
        <source>x %1, y %2, z %3 m</source>
        <translation>x %1, y %2, z %3 m</translation>
    </message>
    <message>
        <source>not known</source>
        <translation>不明</translation>
    </message>
    <message>
        <source>none</source>
        <translation>なし</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>はい</translation>
    </message>
    <message>
        <source>Competition</source>
        <translation>大会</translation>
    </message>
    <message>
        <source>Team</source>
        <translation>チーム</translation>
    </message>
    <message>
        <source>Mission</source>
        <translation>ミッション</translation>
    </message>
    <message>
        <source>Date</source>
        <translation>日付</translation>
    </message>
    <message>
        <source>Duration</source>
        <translation>所要時間</translation>
    </message>
    <message>
        <source>%1 by the mission&apos;s clock</source>
        <translation>%1（ミッション時計）</translation>
    </message>
    <message>
        <source>Operators</source>
        <translation>オペレータ</translation>
    </message>
    <message>
        <source>Area</source>
        <translation>エリア</translation>
    </message>
    <message>
        <source>Stations</source>
        <translation>操作卓</translation>
    </message>
    <message>
        <source>Map</source>
        <translation>地図</translation>
    </message>
    <message>
        <source>%1 scans, %2 m² explored</source>
        <translation>スキャン %1 件、探索済み %2 m²</translation>
    </message>
    <message>
        <source>Robot</source>
        <translation>ロボット</translation>
    </message>
    <message>
        <source>Way</source>
        <translation>経路</translation>
    </message>
    <message>
        <source>Scans in the map</source>
        <translation>地図内のスキャン</translation>
    </message>
    <message>
        <source>Autonomous</source>
        <translation>自律</translation>
    </message>
    <message>
        <source>Teleoperated</source>
        <translation>遠隔操作</translation>
    </message>
    <message>
        <source>%1 m</source>
        <translation>%1 m</translation>
    </message>
    <message>
        <source>Nothing was filed.</source>
        <translation>登録なし</translation>
    </message>
    <message>
        <source>What</source>
        <translation>種類</translation>
    </message>
    <message>
        <source>Status</source>
        <translation>状態</translation>
    </message>
    <message>
        <source>Place in the map</source>
        <translation>地図上の位置</translation>
    </message>
    <message>
        <source>Found</source>
        <translation>発見時刻</translation>
    </message>
    <message>
        <source>By</source>
        <translation>発見者</translation>
    </message>
    <message>
        <source>No robot drove near it: there is no way to tell.</source>
        <translation>付近を走行したロボットがないため、経路は示せない。</translation>
    </message>
    <message>
        <source>%1 m from the start of %2 along the driven trail, the last %3 m straight on.</source>
        <translation>%2 の出発点から走行経路沿いに %1 m、最後の %3 m は直進。</translation>
    </message>
    <message>
        <source>%1 m from the start of %2 along the driven trail; for the last %3 m, no free straight way is known.</source>
        <translation>%2 の出発点から走行経路沿いに %1 m。最後の %3 m は、障害物のない直線経路が確認されていない。</translation>
    </message>
    <message>
        <source>Report of a rescue mission</source>
        <translation>救助ミッション報告書</translation>
    </message>
    <message>
        <source>Robots</source>
        <translation>ロボット</translation>
    </message>
    <message>
        <source>%1 others were discarded or merged.</source>
        <translation>ほか %1 件は破棄または統合。</translation>
    </message>
    <message>
        <source>What was computed where</source>
        <translation>何をどこで計算したか</translation>
    </message>
    <message>
        <source>What is missing or doubtful</source>
        <translation>欠けている点・疑わしい点</translation>
    </message>
    <message>
        <source>and %1 more</source>
        <translation>ほか %1 件</translation>
    </message>
    <message>
        <source>, ± %1 m</source>
        <translation>, ± %1 m</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>高さ</translation>
    </message>
    <message>
        <source>%1 m above the floor</source>
        <translation>床から %1 m</translation>
    </message>
    <message>
        <source>%1, %2 after the mission&apos;s begin</source>
        <translation>%1、ミッション開始から %2</translation>
    </message>
    <message>
        <source>Tag</source>
        <translation>札</translation>
    </message>
    <message>
        <source>Form</source>
        <translation>フォーム</translation>
    </message>
    <message>
        <source>Motion</source>
        <translation>動き</translation>
    </message>
    <message>
        <source>Heat</source>
        <translation>熱</translation>
    </message>
    <message>
        <source>Sound</source>
        <translation>音</translation>
    </message>
    <message>
        <source>CO₂</source>
        <translation>CO₂</translation>
    </message>
    <message>
        <source>Situation</source>
        <translation>状況</translation>
    </message>
    <message>
        <source>Notes</source>
        <translation>メモ</translation>
    </message>
    <message>
        <source>Evidence</source>
        <translation>証拠</translation>
    </message>
    <message>
        <source>The way to %1</source>
        <translation>%1 への経路</translation>
    </message>
    <message>
        <source>%1: map at %2 to %3 m above the floor</source>
        <translation>%1: 床上 %2～%3 m の地図</translation>
    </message>
    <message>
        <source>Finds</source>
        <translation>発見</translation>
    </message>
    <message>
        <source>Report made</source>
        <translation>報告書作成</translation>
    </message>
    <message>
        <source>; storey %1: %2 m²</source>
        <translation>、%1階: %2 m²</translation>
    </message>
    <message>
        <source>Storey</source>
        <translation>階</translation>
    </message>
    <message>
        <source> of storey %1</source>
        <translation>（%1階）</translation>
    </message>
    <message>
        <source>%1: storey %2, map at %3 to %4 m above its floor</source>
        <translation>%1: %2階、その床から %3〜%4 m の地図</translation>
    </message>
</context>
<context>
    <name>ScoreText</name>
    <message>
        <source>teleoperated</source>
        <translation>遠隔操作</translation>
    </message>
    <message>
        <source>robot drove, station or operator found</source>
        <translation>走行はロボット、発見は操作卓またはオペレータ</translation>
    </message>
    <message>
        <source>robot drove and found by itself</source>
        <translation>走行も発見もロボット自身</translation>
    </message>
    <message>
        <source>Score, estimated</source>
        <translation>得点（推定）</translation>
    </message>
    <message>
        <source>Profile %1 (%2), version %3. The quality of the map is the judges&apos; to tell; here it counts as full.</source>
        <translation>プロファイル %1（%2）、バージョン %3。地図の質は審判が判定する。ここでは満点として計算。</translation>
    </message>
    <message>
        <source>Items</source>
        <translation>項目</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>点数</translation>
    </message>
    <message>
        <source>Area</source>
        <translation>エリア</translation>
    </message>
    <message>
        <source>Autonomy</source>
        <translation>自律性</translation>
    </message>
    <message>
        <source>Total</source>
        <translation>合計</translation>
    </message>
    <message>
        <source>%1 (not confirmed)</source>
        <translation>%1（未確定）</translation>
    </message>
    <message>
        <source>%1 of the finds, less %2 for contacts (%3 with the arena, %4 with victims), divided by %5 (operators: %6): &lt;b&gt;%7&lt;/b&gt;</source>
        <translation>発見 %1 点から、アリーナとの接触 %3 回と被災者との接触 %4 回の減点 %2 を引き、%5 で割る（オペレータ %6 名）: &lt;b&gt;%7&lt;/b&gt;</translation>
    </message>
    <message>
        <source>Values of the profile for which no readable source was found: %1.</source>
        <translation>参照できる出典が見つからなかったプロファイル値: %1。</translation>
    </message>
    <message>
        <source>weights of the areas</source>
        <translation>エリアの重み</translation>
    </message>
    <message>
        <source>points of the items</source>
        <translation>各項目の得点</translation>
    </message>
    <message>
        <source>penalty of a contact with the arena</source>
        <translation>アリーナ接触の減点</translation>
    </message>
    <message>
        <source>penalty of a contact with a victim</source>
        <translation>被災者接触の減点</translation>
    </message>
    <message>
        <source>divisor by operators</source>
        <translation>操作者数による除数</translation>
    </message>
    <message>
        <source>points of a hazard sign</source>
        <translation>危険物標識の得点</translation>
    </message>
    <message>
        <source>points of a QR code</source>
        <translation>QRコードの得点</translation>
    </message>
    <message>
        <source>points of an object of interest</source>
        <translation>対象物の得点</translation>
    </message>
    <message>
        <source>factor of autonomy</source>
        <translation>自律の係数</translation>
    </message>
    <message>
        <source>factor of semi-autonomy</source>
        <translation>半自律の係数</translation>
    </message>
    <message>
        <source>minutes of a mission</source>
        <translation>ミッションの分数</translation>
    </message>
    <message>
        <source>The profile has no weight for the area “%1”: its finds count once.</source>
        <translation>プロファイルにはエリア「%1」の重みがありません: そこでの発見は1倍です。</translation>
    </message>
    <message>
        <source>storey %1: %2</source>
        <translation>%1階: %2</translation>
    </message>
    <message>
        <source>Of the finds, by storey: %1.</source>
        <translation>発見の階別内訳: %1。</translation>
    </message>
    <message>
        <source>Storey</source>
        <translation>階</translation>
    </message>
</context>
<context>
    <name>WorkText</name>
    <message>
        <source>body heat</source>
        <translation>体温</translation>
    </message>
    <message>
        <source>motion</source>
        <translation>動き</translation>
    </message>
    <message>
        <source>CO₂</source>
        <translation>CO₂</translation>
    </message>
    <message>
        <source>QR codes</source>
        <translation>QRコード</translation>
    </message>
    <message>
        <source>hazard signs</source>
        <translation>危険物標識</translation>
    </message>
    <message>
        <source>%1 drove by itself for %2</source>
        <translation>%1 は %2 自律走行</translation>
    </message>
    <message>
        <source>no robot drove by itself</source>
        <translation>自律走行したロボットはない</translation>
    </message>
    <message>
        <source>there was no map to be made</source>
        <translation>作成する地図はなかった</translation>
    </message>
    <message>
        <source>this report was written</source>
        <translation>この報告書を作成</translation>
    </message>
    <message>
        <source>%1 was driven for %2</source>
        <translation>%1 を %2 操縦</translation>
    </message>
    <message>
        <source>On the robots:</source>
        <translation>ロボット上:</translation>
    </message>
    <message>
        <source>On the operator station:</source>
        <translation>操作卓上:</translation>
    </message>
    <message>
        <source>By people:</source>
        <translation>人:</translation>
    </message>
    <message>
        <source>candidates that they saw by themselves: %1</source>
        <translation>ロボット自身が見た候補: %1 件</translation>
    </message>
    <message>
        <source>scans registered into this map while robots drove: %1</source>
        <translation>走行中にこの地図へ位置合わせしたスキャン: %1 件</translation>
    </message>
    <message>
        <source>scans registered into this map for this report: %1</source>
        <translation>この報告書のためにこの地図へ位置合わせしたスキャン: %1 件</translation>
    </message>
    <message>
        <source>candidates reported: %1</source>
        <translation>通知した候補: %1 件</translation>
    </message>
    <message>
        <source>candidates reported: %1, by %2</source>
        <translation>通知した候補: %1 件（%2）</translation>
    </message>
    <message>
        <source>finds filed: %1, reported by a station before: %2, confirmed: %3</source>
        <translation>登録した発見: %1 件、うち操作卓が通知したもの: %2 件、確定: %3 件</translation>
    </message>
    <message>
        <source>decisions on scans and the map&apos;s area: %1</source>
        <translation>スキャンと地図範囲についての判断: %1 件</translation>
    </message>
    <message>
        <source>tags of victims</source>
        <translation>被災者のタグ</translation>
    </message>
</context>
<context>
    <name>leitstand::AlarmLine</name>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>battery: %1 min left</source>
        <translation>バッテリー: 残り %1 min</translation>
    </message>
    <message>
        <source>battery: %1 % left</source>
        <translation>バッテリー: 残り %1 %</translation>
    </message>
    <message>
        <source>its clock is %1 s ahead</source>
        <translation>ロボットの時計が %1 s 進んでいる</translation>
    </message>
    <message>
        <source>its clock is %1 s behind</source>
        <translation>ロボットの時計が %1 s 遅れている</translation>
    </message>
    <message>
        <source>tilted: %1 % of where it tips over</source>
        <translation>傾斜: 転倒限界の %1 %</translation>
    </message>
    <message>
        <source>rolled over, tilted by %1°</source>
        <translation>転倒、傾斜 %1°</translation>
    </message>
    <message>
        <source>link lost, silent for %1</source>
        <translation>通信途絶、%1 応答なし</translation>
    </message>
    <message>
        <source>link: %1</source>
        <translation>通信: %1</translation>
    </message>
    <message>
        <source>CO₂ %1 ppm</source>
        <translation>CO₂ %1 ppm</translation>
    </message>
    <message>
        <source>bumped: %1</source>
        <translation>衝突: %1</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>does not answer STOP for %1</source>
        <translation>STOP に %1 応答なし</translation>
    </message>
    <message>
        <source>camera %1 repeats one picture for %2</source>
        <translation>カメラ %1 が %2 同じ映像を反復</translation>
    </message>
    <message>
        <source>drive control was lost to %1</source>
        <translation>操縦権が %1 へ移った</translation>
    </message>
    <message>
        <source>uncertain scans to be decided on: %1</source>
        <translation>判断待ちの不確実なスキャン: %1</translation>
    </message>
    <message>
        <source>log: %1</source>
        <translation>ログ: %1</translation>
    </message>
    <message>
        <source>over for %1</source>
        <translation>終息後 %1</translation>
    </message>
    <message>
        <source>muted for %1 s</source>
        <translation>消音中 %1 s</translation>
    </message>
    <message>
        <source>not heard: %1</source>
        <translation>受信なし: %1</translation>
    </message>
    <message>
        <source>wheels turned for %1 m, the map says it stands</source>
        <translation>車輪は %1 m 回転したが、地図では止まったまま</translation>
    </message>
</context>
<context>
    <name>leitstand::AlarmListModel</name>
    <message>
        <source>Station</source>
        <translation>操作卓</translation>
    </message>
    <message>
        <source>Act</source>
        <translation>対処</translation>
    </message>
    <message>
        <source>Look</source>
        <translation>注意</translation>
    </message>
    <message>
        <source> · acknowledged</source>
        <translation> · 確認済み</translation>
    </message>
</context>
<context>
    <name>leitstand::AlarmPanel</name>
    <message>
        <source>No alarms</source>
        <translation>警報なし</translation>
    </message>
    <message>
        <source>Alarms</source>
        <translation>警報</translation>
    </message>
    <message>
        <source>Alarms, newest first; Return acknowledges the chosen one</source>
        <translation>警報（新しい順）。Return で選択した警報を確認</translation>
    </message>
    <message>
        <source>⌫ Acknowledge</source>
        <translation>⌫ 確認</translation>
    </message>
    <message>
        <source>Acknowledges the newest alarm that is not: its tone ends</source>
        <translation>未確認の最新警報を確認。警報音が止まる</translation>
    </message>
    <message>
        <source>Acknowledge the newest alarm</source>
        <translation>最新の警報を確認</translation>
    </message>
    <message>
        <source>No tones for one minute; alarms are shown all the same</source>
        <translation>1 分間消音。警報の表示は続く</translation>
    </message>
    <message>
        <source>Alarms, newest first</source>
        <translation>警報（新しい順）</translation>
    </message>
    <message>
        <source>Alarms · %1</source>
        <translation>警報 · %1</translation>
    </message>
    <message>
        <source>M Mute</source>
        <translation>M 消音</translation>
    </message>
    <message>
        <source>M %1</source>
        <translation>M %1</translation>
    </message>
    <message>
        <source>Mute tones for one minute</source>
        <translation>警報音を 1 分間消音</translation>
    </message>
</context>
<context>
    <name>leitstand::AlarmsFeature</name>
    <message>
        <source>&amp;Acknowledge the newest alarm</source>
        <translation>最新の警報を確認(&amp;A)</translation>
    </message>
    <message>
        <source>Its tone ends; it stays in the list while it stands</source>
        <translation>警報音が止まる。警報が続く間は一覧に残る</translation>
    </message>
    <message>
        <source>&amp;Mute alarms for a minute</source>
        <translation>警報を 1 分間消音(&amp;M)</translation>
    </message>
    <message>
        <source>No tones; again: tones at once</source>
        <translation>消音。再度押すと直ちに音を戻す</translation>
    </message>
</context>
<context>
    <name>leitstand::Application</name>
    <message>
        <source>%1 was recorded until a moment ago: Mission ▸ Go on with the mission before (or leitstand --resume)</source>
        <translation>%1 は直前まで記録されていました: ミッション ▸ 前のミッションを続ける (または leitstand --resume)</translation>
    </message>
    <message>
        <source>The map of %1 is being copied.</source>
        <translation>%1の地図をコピーしています。</translation>
    </message>
</context>
<context>
    <name>leitstand::AttitudeGauge</name>
    <message>
        <source>Attitude</source>
        <translation>姿勢</translation>
    </message>
    <message>
        <source>The blue line is the horizon. Where it reaches the dots, the robot tips over.</source>
        <translation>青線は水平線。これが点に達するとロボットは転倒する。</translation>
    </message>
</context>
<context>
    <name>leitstand::BottomStrip</name>
    <message>
        <source>Reading %1</source>
        <translation>読込中 %1</translation>
    </message>
    <message>
        <source>Reading %1 · %2 of %3</source>
        <translation>読込中 %1 · %2 / %3</translation>
    </message>
    <message>
        <source>Registering %1 · %2 of %3</source>
        <translation>位置合わせ中 %1 · %2 / %3</translation>
    </message>
    <message>
        <source>▲ 1 error</source>
        <translation>▲ エラー 1 件</translation>
    </message>
    <message>
        <source>▲ %1 errors</source>
        <translation>▲ エラー %1 件</translation>
    </message>
    <message>
        <source>1 message</source>
        <translation>メッセージ 1 件</translation>
    </message>
    <message>
        <source>%1 messages</source>
        <translation>メッセージ %1 件</translation>
    </message>
    <message>
        <source>No messages</source>
        <translation>メッセージなし</translation>
    </message>
</context>
<context>
    <name>leitstand::BrakeSays</name>
    <message>
        <source>brake not tested</source>
        <translation>ブレーキは未試験</translation>
    </message>
    <message>
        <source>brake test passed: it stood after {} ms and {} cm</source>
        <translation>ブレーキ試験合格: {} ms、{} cm で停止</translation>
    </message>
    <message>
        <source>brake test passed: without commands it braked after {} ms and stood after {} ms and {} cm</source>
        <translation>ブレーキ試験 合格: 指令なしで {} ms 後に制動し、{} ms・{} cm で停止</translation>
    </message>
    <message>
        <source>brake test FAILED: without commands it braked after {} ms and stood only after {} ms and {} cm</source>
        <translation>ブレーキ試験 不合格: 指令なしで {} ms 後に制動し、停止は {} ms・{} cm 後</translation>
    </message>
    <message>
        <source>brake test FAILED: without commands it still moved after {} ms and {} cm</source>
        <translation>ブレーキ試験不合格: 指令なしで {} ms、{} cm 後もまだ動いていた</translation>
    </message>
    <message>
        <source>brake test without result: {}</source>
        <translation>ブレーキ試験は結果なし: {}</translation>
    </message>
    <message>
        <source>only {} cm are free ahead, {} cm are needed</source>
        <translation>前方の空きは {} cm のみ、{} cm 必要</translation>
    </message>
</context>
<context>
    <name>leitstand::ByHandWindow</name>
    <message>
        <source>The map is made ready to be corrected.</source>
        <translation>地図を修正できるよう準備しています。</translation>
    </message>
    <message>
        <source>The map follows what was decided. The review opens again then.</source>
        <translation>決定に合わせて地図を更新しています。その後、レビューが再び開きます。</translation>
    </message>
    <message>
        <source>The map is as it was left by hand</source>
        <translation>地図は手作業で修正された状態です</translation>
    </message>
    <message>
        <source>%1 – map by hand – Leitstand</source>
        <translation>%1 – 地図の手動修正 – Leitstand</translation>
    </message>
    <message>
        <source>Back to the &amp;review</source>
        <translation>レビューに戻る(&amp;R)</translation>
    </message>
    <message>
        <source>The review opens again, on the map as it is now. What was decided here is in the mission, and can be taken back here, also later</source>
        <translation>現在の地図でレビューが再び開きます。ここでの決定はミッションに記録され、後からでもここで取り消せます</translation>
    </message>
    <message>
        <source>MAP BY HAND · %1</source>
        <translation>地図の手動修正 · %1</translation>
    </message>
</context>
<context>
    <name>leitstand::CameraFeature</name>
    <message>
        <source>Re-&amp;centre cameras</source>
        <translation>カメラを正面へ(&amp;C)</translation>
    </message>
    <message>
        <source>All cameras of the robot look ahead</source>
        <translation>ロボットの全カメラを正面へ向ける</translation>
    </message>
    <message>
        <source>Turns the large camera by 10 degrees; its keys turn it while they are held</source>
        <translation>大画面のカメラを 10 度旋回。キーは押している間旋回</translation>
    </message>
    <message>
        <source>Turn &amp;left	Q</source>
        <translation>左へ旋回(&amp;L)	Q</translation>
    </message>
    <message>
        <source>Turn &amp;right	E</source>
        <translation>右へ旋回(&amp;R)	E</translation>
    </message>
    <message>
        <source>Turn &amp;up	PgUp</source>
        <translation>上へ旋回(&amp;U)	PgUp</translation>
    </message>
    <message>
        <source>Turn &amp;down	PgDown</source>
        <translation>下へ旋回(&amp;D)	PgDown</translation>
    </message>
    <message>
        <source>&amp;Next small picture</source>
        <translation>次の小画面映像(&amp;N)</translation>
    </message>
    <message>
        <source>Shows the next camera of the robot in the small pane</source>
        <translation>小画面にロボットの次のカメラを表示</translation>
    </message>
    <message>
        <source>E&amp;xchange both pictures</source>
        <translation>両映像を入れ替え(&amp;X)</translation>
    </message>
    <message>
        <source>The camera in the small pane gets the large one</source>
        <translation>小画面のカメラを大画面に表示</translation>
    </message>
    <message>
        <source>More contrast in pictures: gently, strongly, not. The log keeps them as they came</source>
        <translation>映像のコントラスト強調: 弱、強、なし。ログには元の映像を保存</translation>
    </message>
    <message>
        <source>Omnidirectional as &amp;panorama</source>
        <translation>全方位をパノラマ表示(&amp;P)</translation>
    </message>
    <message>
        <source>All around in one strip, ahead in the middle; or as the mirror shows it</source>
        <translation>全周を 1 本の帯で表示（中央が前方）、またはミラー像のまま表示</translation>
    </message>
    <message>
        <source>Keep a &amp;snapshot</source>
        <translation>静止画を保存(&amp;S)</translation>
    </message>
    <message>
        <source>The newest large picture, as it came, into the mission&apos;s folder snapshots</source>
        <translation>最新の大画面映像を受信時のまま、ミッションの snapshots フォルダに保存</translation>
    </message>
    <message>
        <source>Keep a snapshot of the s&amp;mall picture</source>
        <translation>小画面の静止画を保存(&amp;M)</translation>
    </message>
    <message>
        <source>The same of the small picture</source>
        <translation>小画面の映像を同様に保存</translation>
    </message>
    <message>
        <source>Infrared in &amp;iron colours</source>
        <translation>赤外線: アイアン配色(&amp;I)</translation>
    </message>
    <message>
        <source>Infrared in grey, &amp;hot is white</source>
        <translation>赤外線: グレー、高温が白(&amp;H)</translation>
    </message>
    <message>
        <source>Infrared colours &amp;follow the picture</source>
        <translation>赤外線配色を映像に追従(&amp;F)</translation>
    </message>
    <message>
        <source>From its coldest to its hottest; otherwise a colour is always the same temperature</source>
        <translation>映像内の最低温から最高温まで。オフでは同じ色が常に同じ温度を示す</translation>
    </message>
    <message>
        <source>There is no picture to keep yet</source>
        <translation>保存できる映像がまだない</translation>
    </message>
    <message>
        <source>no picture of %1</source>
        <translation>%1 の映像なし</translation>
    </message>
    <message>
        <source>The camera sees nothing there: nothing was filed</source>
        <translation>カメラはそこを写していない: 登録なし</translation>
    </message>
    <message>
        <source>Help in the d&amp;ark</source>
        <translation>暗所の補助(&amp;A)</translation>
    </message>
    <message>
        <source>Infrared in grey, hot is &amp;black</source>
        <translation>赤外線を灰色で、高温は黒(&amp;B)</translation>
    </message>
</context>
<context>
    <name>leitstand::CameraKeys</name>
    <message>
        <source>Q E PgUp PgDn</source>
        <translation>Q E PgUp PgDn</translation>
    </message>
</context>
<context>
    <name>leitstand::CameraPane</name>
    <message>
        <source>colours follow the picture</source>
        <translation>配色は映像に追従</translation>
    </message>
    <message>
        <source>%1 m</source>
        <translation>%1 m</translation>
    </message>
    <message>
        <source>ahead</source>
        <translation>前方</translation>
    </message>
    <message>
        <source>pan %1</source>
        <translation>パン %1</translation>
    </message>
    <message>
        <source>pan %1 left</source>
        <translation>パン 左 %1</translation>
    </message>
    <message>
        <source>pan %1 right</source>
        <translation>パン 右 %1</translation>
    </message>
    <message>
        <source>%1 down</source>
        <translation>下 %1</translation>
    </message>
    <message>
        <source>%1 up</source>
        <translation>上 %1</translation>
    </message>
    <message>
        <source>%1 turns the cameras</source>
        <translation>%1 がカメラを操作中</translation>
    </message>
    <message>
        <source>asking for the cameras</source>
        <translation>カメラ操作権を要求中</translation>
    </message>
    <message>
        <source>No camera</source>
        <translation>カメラなし</translation>
    </message>
    <message>
        <source>Infrared °C</source>
        <translation>赤外線 °C</translation>
    </message>
    <message>
        <source>Infrared</source>
        <translation>赤外線</translation>
    </message>
    <message>
        <source>Left camera</source>
        <translation>左カメラ</translation>
    </message>
    <message>
        <source>Right camera</source>
        <translation>右カメラ</translation>
    </message>
    <message>
        <source>Omnidirectional camera</source>
        <translation>全方位カメラ</translation>
    </message>
    <message>
        <source>Camera</source>
        <translation>カメラ</translation>
    </message>
    <message>
        <source>contrast raised</source>
        <translation>コントラスト強調（弱）</translation>
    </message>
    <message>
        <source>contrast raised strongly</source>
        <translation>コントラスト強調（強）</translation>
    </message>
    <message>
        <source>%1 turn</source>
        <translation>%1 旋回</translation>
    </message>
    <message>
        <source>%1 re-centres</source>
        <translation>%1 正面</translation>
    </message>
    <message>
        <source>left 90°</source>
        <translation>左 90°</translation>
    </message>
    <message>
        <source>right 90°</source>
        <translation>右 90°</translation>
    </message>
    <message>
        <source>behind</source>
        <translation>後方</translation>
    </message>
    <message>
        <source>The ring tells how near things are: faint is far, dots are unknown, amber near, thick red-orange at the body.
The blue line is the horizon.</source>
        <translation>リングは周囲の近さを示す: 薄色は遠い、点は不明、琥珀色は近い、太い赤橙は車体に接近。
青線は水平線。</translation>
    </message>
</context>
<context>
    <name>leitstand::ChangedModel</name>
    <message>
        <source>now</source>
        <translation>現在</translation>
    </message>
    <message>
        <source>new</source>
        <translation>新規</translation>
    </message>
    <message>
        <source>gone</source>
        <translation>消失</translation>
    </message>
    <message>
        <source>%1 × %2 × %3 m</source>
        <translation>%1 × %2 × %3 m</translation>
    </message>
    <message>
        <source>x %1, y %2</source>
        <translation>x %1、y %2</translation>
    </message>
    <message>
        <source>%1 → %2: new %3, gone %4</source>
        <translation>%1 → %2: 新規%3、消失%4</translation>
    </message>
    <message>
        <source>What changed is being looked for</source>
        <translation>変化を調べています</translation>
    </message>
    <message>
        <source>The map is of one mission alone: there is nothing to compare it with</source>
        <translation>地図は1つのミッションだけのものです。比較する相手がありません</translation>
    </message>
    <message>
        <source>Where both looked, nothing changed</source>
        <translation>両方で見た所に変化はありません</translation>
    </message>
    <message>
        <source>No.</source>
        <translation>番号</translation>
    </message>
    <message>
        <source>What</source>
        <translation>種類</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>大きさ</translation>
    </message>
    <message>
        <source>Where</source>
        <translation>位置</translation>
    </message>
    <message>
        <source>In the map</source>
        <translation>地図上</translation>
    </message>
    <message>
        <source>The maps of the missions have not met yet: nothing can be compared</source>
        <translation>ミッションの地図がまだ出会っていないため、比較できません</translation>
    </message>
</context>
<context>
    <name>leitstand::ChangesFeature</name>
    <message>
        <source>What c&amp;hanged</source>
        <translation>変化したもの(&amp;H)</translation>
    </message>
    <message>
        <source>Colours and lists what came and what went since the missions before: in a map that is put together from several</source>
        <translation>以前のミッションから増えたものとなくなったものを色分けして一覧にします（複数のミッションからなる地図の場合）</translation>
    </message>
    <message>
        <source>Show what chan&amp;ged on the map</source>
        <translation>変化したものを地図に表示(&amp;G)</translation>
    </message>
    <message>
        <source>Moves the map to what is chosen in the list</source>
        <translation>一覧で選んだものへ地図を移動します</translation>
    </message>
    <message>
        <source>Show</source>
        <translation>表示</translation>
    </message>
    <message>
        <source>Choose something in the list of what changed</source>
        <translation>変化したものの一覧から選んでください</translation>
    </message>
</context>
<context>
    <name>leitstand::ChangesPanel</name>
    <message>
        <source>What changed</source>
        <translation>変化したもの</translation>
    </message>
    <message>
        <source>What came and what went, the largest first</source>
        <translation>増えたものとなくなったもの（大きい順）</translation>
    </message>
</context>
<context>
    <name>leitstand::ClockFace</name>
    <message>
        <source>Mission clock</source>
        <translation>ミッション時計</translation>
    </message>
</context>
<context>
    <name>leitstand::ClockText</name>
    <message>
        <source>running</source>
        <translation>計時中</translation>
    </message>
    <message>
        <source>time</source>
        <translation>経過</translation>
    </message>
    <message>
        <source>Mission time %1, %2</source>
        <translation>ミッション時間 %1、%2</translation>
    </message>
    <message>
        <source>over</source>
        <translation>超過</translation>
    </message>
    <message>
        <source>left</source>
        <translation>残り</translation>
    </message>
    <message>
        <source>Mission time %1 of %2, %3</source>
        <translation>ミッション時間 %1 / %2、%3</translation>
    </message>
    <message>
        <source>paused</source>
        <translation>停止中</translation>
    </message>
</context>
<context>
    <name>leitstand::ClosingQuestion</name>
    <message>
        <source>Close the station</source>
        <translation>ステーションを閉じる</translation>
    </message>
    <message>
        <source>Driving by itself: %1</source>
        <translation>自律走行中：%1</translation>
    </message>
    <message>
        <source>Left driving, it goes on, and this station can stop it no more. Stopped, it stands until a station releases it. Robots that somebody drives from here stand in any case. Esc stops all robots at once.</source>
        <translation>走行を続けさせると走り続け、このステーションからはもう停止できません。停止させると、ステーションが解除するまで停止したままです。ここから操縦されているロボットはいずれにせよ停止します。Esc で全ロボットを直ちに停止します。</translation>
    </message>
    <message>
        <source>Stop and close</source>
        <translation>停止して閉じる</translation>
    </message>
    <message>
        <source>Leave driving and close</source>
        <translation>走行させたまま閉じる</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>キャンセル</translation>
    </message>
    <message>
        <source>Closes as soon as they stand</source>
        <translation>停止し次第閉じます</translation>
    </message>
    <message>
        <source>No answer to the stop. Close all the same?</source>
        <translation>停止に応答がありません。それでも閉じますか？</translation>
    </message>
</context>
<context>
    <name>leitstand::CommandTable</name>
    <message>
        <source>&amp;Mission</source>
        <translation>ミッション(&amp;M)</translation>
    </message>
    <message>
        <source>&amp;Robot</source>
        <translation>ロボット(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;Cameras</source>
        <translation>カメラ(&amp;C)</translation>
    </message>
    <message>
        <source>M&amp;ap</source>
        <translation>地図(&amp;A)</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>表示(&amp;V)</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>ヘルプ(&amp;H)</translation>
    </message>
</context>
<context>
    <name>leitstand::CompareFeature</name>
    <message>
        <source>&amp;Compare registrations</source>
        <translation>レジストレーションを比較(&amp;C)</translation>
    </message>
    <message>
        <source>Registers the key scans with other settings and shows both maps and their figures</source>
        <translation>別の設定でキースキャンを再レジストレーションし、両方の地図と数値を表示</translation>
    </message>
    <message>
        <source>The mission is still read through</source>
        <translation>ミッションを読み込み中</translation>
    </message>
</context>
<context>
    <name>leitstand::ComparePanel</name>
    <message>
        <source>Registered again and compared</source>
        <translation>再レジストレーションと比較</translation>
    </message>
    <message>
        <source>How far the comparison is</source>
        <translation>比較の進み具合</translation>
    </message>
    <message>
        <source>M&amp;inimise</source>
        <translation>最小化(&amp;I)</translation>
    </message>
    <message>
        <source>Pairs of points farther apart are dropped; 0.01 to 10 m. Several values are stages, each at most the one before: 1.5, 0.5</source>
        <translation>これより離れた点の組は除外。0.01～10 m。複数の値は段階で、前の値以下: 1.5, 0.5</translation>
    </message>
    <message>
        <source>m</source>
        <translation>m</translation>
    </message>
    <message>
        <source>all points</source>
        <translation>全点</translation>
    </message>
    <message>
        <source>Voxe&amp;ls</source>
        <translation>ボクセル(&amp;L)</translation>
    </message>
    <message>
        <source>Edge of the grid to which scans are thinned</source>
        <translation>スキャンを間引く格子の辺の長さ</translation>
    </message>
    <message>
        <source>Recorded</source>
        <translation>記録時</translation>
    </message>
    <message>
        <source>The map pane shows the mission&apos;s own map</source>
        <translation>地図にミッション自身の地図を表示</translation>
    </message>
    <message>
        <source>Again</source>
        <translation>再計算</translation>
    </message>
    <message>
        <source>It shows the map registered again</source>
        <translation>再レジストレーションした地図を表示</translation>
    </message>
    <message>
        <source>Both</source>
        <translation>両方</translation>
    </message>
    <message>
        <source>It shows both: the recorded one in grey, the one registered again in its colours</source>
        <translation>両方を表示: 記録時は灰色、再計算は通常の色</translation>
    </message>
    <message>
        <source>Figures</source>
        <translation>数値</translation>
    </message>
    <message>
        <source>Key scans</source>
        <translation>キースキャン</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>中止</translation>
    </message>
    <message>
        <source>Register again</source>
        <translation>再レジストレーション</translation>
    </message>
    <message>
        <source>What was compared before stays</source>
        <translation>前の比較は残る</translation>
    </message>
    <message>
        <source>Registers the mission&apos;s key scans with these settings and compares; the mission stays as it is</source>
        <translation>この設定でミッションのキースキャンを再レジストレーションして比較。ミッションは変更しない</translation>
    </message>
    <message>
        <source>Registers the mission&apos;s key scans once more, with these settings, and puts both maps beside each other: how well scans meet, how far they moved, how long it took. Nothing of the mission is changed. The newest result is kept with it.</source>
        <translation>ミッションのキースキャンをこの設定でもう一度登録し、両方の地図を比べる: スキャンの合い方、移動量、所要時間。ミッションは変更しない。最新の結果はミッションと共に保存される。</translation>
    </message>
    <message>
        <source>A&amp;gainst</source>
        <translation>対象(&amp;G)</translation>
    </message>
    <message>
        <source>Maximum &amp;distance</source>
        <translation>最大距離(&amp;D)</translation>
    </message>
</context>
<context>
    <name>leitstand::ComparedSummary</name>
    <message>
        <source>recorded</source>
        <translation>記録</translation>
    </message>
    <message>
        <source>registered again</source>
        <translation>再登録</translation>
    </message>
    <message>
        <source>recorded (grey) and registered again</source>
        <translation>記録（灰）と再登録</translation>
    </message>
    <message>
        <source>3D map</source>
        <translation>3D 地図</translation>
    </message>
    <message>
        <source>%1 key scans</source>
        <translation>キースキャン %1 件</translation>
    </message>
    <message>
        <source>How far key scans are from where they were recorded</source>
        <translation>キースキャンが記録時の位置からどれだけ離れているか</translation>
    </message>
</context>
<context>
    <name>leitstand::Comparison</name>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>%1, at most %2</source>
        <comment>mean and largest</comment>
        <translation>%1、最大 %2</translation>
    </message>
    <message>
        <source>Off the truth</source>
        <translation>真値との差</translation>
    </message>
    <message>
        <source>Root mean square of the robots&apos; positions at the key scans, after the map was turned and shifted to fit the recorded truth best</source>
        <translation>記録された真値に地図を最もよく合わせた後の、キースキャンでのロボット位置の二乗平均平方根</translation>
    </message>
    <message>
        <source>Turned off the truth</source>
        <translation>真値との角度差</translation>
    </message>
    <message>
        <source>The same of their attitudes</source>
        <translation>姿勢について同様</translation>
    </message>
    <message>
        <source>Victims off the truth</source>
        <translation>被災者の真値との差</translation>
    </message>
    <message>
        <source>%1 m</source>
        <translation>%1 m</translation>
    </message>
    <message>
        <source>Figure</source>
        <translation>項目</translation>
    </message>
    <message>
        <source>As recorded</source>
        <translation>記録時</translation>
    </message>
    <message>
        <source>Registered again</source>
        <translation>再レジストレーション</translation>
    </message>
    <message>
        <source>Key scans</source>
        <translation>キースキャン</translation>
    </message>
    <message>
        <source>Those that were not set aside</source>
        <translation>除外されていないもの</translation>
    </message>
    <message>
        <source>Uncertain</source>
        <translation>不確実</translation>
    </message>
    <message>
        <source>Scans of which the registration was not sure</source>
        <translation>レジストレーションが不確実だったスキャン</translation>
    </message>
    <message>
        <source>Set aside</source>
        <translation>除外</translation>
    </message>
    <message>
        <source>Rejected or rewound by the operator; they are not registered again</source>
        <translation>操縦者が除外または巻き戻したもの。再レジストレーションしない</translation>
    </message>
    <message>
        <source>Residual</source>
        <translation>残差</translation>
    </message>
    <message>
        <source>Mean over scans: root mean square distance to the key scan before, of points that have a partner within 10 cm</source>
        <translation>スキャン平均: 10 cm 以内に対応点を持つ点の、直前のキースキャンまでの距離の二乗平均平方根</translation>
    </message>
    <message>
        <source>Overlap</source>
        <translation>重なり</translation>
    </message>
    <message>
        <source>Mean over scans: share of points that have such a partner</source>
        <translation>スキャン平均: 対応点を持つ点の割合</translation>
    </message>
    <message>
        <source>Path</source>
        <translation>経路</translation>
    </message>
    <message>
        <source>Way of the robots from key scan to key scan</source>
        <translation>キースキャン間のロボットの移動距離</translation>
    </message>
    <message>
        <source>Moved</source>
        <translation>移動</translation>
    </message>
    <message>
        <source>How far scans are from where they were recorded, mean and largest</source>
        <translation>記録時の位置からのずれ、平均と最大</translation>
    </message>
    <message>
        <source>Turned</source>
        <translation>回転</translation>
    </message>
    <message>
        <source>Time taken</source>
        <translation>所要時間</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>Of registering all scans; live, it was spread over the mission</source>
        <translation>全スキャンのレジストレーション時間。実走時はミッション全体に分散</translation>
    </message>
    <message>
        <source>Scan</source>
        <translation>スキャン</translation>
    </message>
    <message>
        <source>again</source>
        <comment>residual of a scan</comment>
        <translation>再計算</translation>
    </message>
    <message>
        <source>again</source>
        <comment>overlap of a scan</comment>
        <translation>再計算</translation>
    </message>
    <message>
        <source>State</source>
        <translation>状態</translation>
    </message>
    <message>
        <source>uncertain again</source>
        <translation>再計算で不確実</translation>
    </message>
    <message>
        <source>was uncertain</source>
        <translation>不確実だった</translation>
    </message>
    <message>
        <source>certain</source>
        <translation>確実</translation>
    </message>
    <message>
        <source>%1 key scans registered again: moved %2 at most</source>
        <translation>キースキャン %1 件を再レジストレーション: 最大移動 %2</translation>
    </message>
    <message>
        <source>moved %1 at most</source>
        <translation>移動は最大 %1</translation>
    </message>
    <message>
        <source>Victims found</source>
        <translation>発見した被災者</translation>
    </message>
    <message>
        <source>True victims that were filed, each find counting for one; missed: those that were not; false: finds within %1 m of no victim, or of one that was filed already</source>
        <translation>登録された実際の被災者 (発見1件につき1人)。見逃し: 登録されなかった人。誤り: %1 m 以内に被災者がいない、またはすでに登録済みの人の発見</translation>
    </message>
    <message>
        <source>%1, missed %2, false %3</source>
        <comment>victims found</comment>
        <translation>%1、見逃し %2、誤り %3</translation>
    </message>
    <message>
        <source>From each victim that was found to where it truly is, seen from above</source>
        <translation>発見した各被災者から実際の位置まで (真上から見た距離)</translation>
    </message>
</context>
<context>
    <name>leitstand::Coverage</name>
    <message>
        <source>Camera</source>
        <translation>カメラ</translation>
    </message>
    <message>
        <source>Infrared</source>
        <translation>赤外線</translation>
    </message>
    <message>
        <source>Scanner</source>
        <translation>スキャナ</translation>
    </message>
</context>
<context>
    <name>leitstand::CoverageFeature</name>
    <message>
        <source>Searched floor: &amp;hidden</source>
        <translation>探索済みの床: 表示しない(&amp;H)</translation>
    </message>
    <message>
        <source>The map as it is</source>
        <translation>地図のみ</translation>
    </message>
    <message>
        <source>Searched by s&amp;canner</source>
        <translation>スキャナで探索済み(&amp;C)</translation>
    </message>
    <message>
        <source>Tints the floor where a body would have enough points, hatches what was missed</source>
        <translation>人体に十分な点が当たる床を着色、見落としは斜線</translation>
    </message>
    <message>
        <source>Searched by came&amp;ra</source>
        <translation>カメラで探索済み(&amp;R)</translation>
    </message>
    <message>
        <source>Tints the floor where a body would span enough pixels of a camera, hatches what was missed</source>
        <translation>人体がカメラに十分な画素で写る床を着色、見落としは斜線</translation>
    </message>
    <message>
        <source>Searched by i&amp;nfrared</source>
        <translation>赤外線で探索済み(&amp;N)</translation>
    </message>
    <message>
        <source>Tints the floor where a body would span enough pixels of an infrared camera, hatches what was missed</source>
        <translation>人体が赤外線カメラに十分な画素で写る床を着色、見落としは斜線</translation>
    </message>
    <message>
        <source>Searched floor: ne&amp;xt sensor</source>
        <translation>探索済みの床: 次のセンサー(&amp;X)</translation>
    </message>
    <message>
        <source>Scanner, camera, infrared, hidden</source>
        <translation>スキャナ、カメラ、赤外線、非表示</translation>
    </message>
    <message>
        <source>&amp;What did I miss?</source>
        <translation>見落としは?(&amp;W)</translation>
    </message>
    <message>
        <source>Lists the floor that robots can reach and that was not seen, the largest piece first</source>
        <translation>到達可能で未確認の床を大きい順に一覧</translation>
    </message>
    <message>
        <source>Go to what was &amp;missed</source>
        <translation>見落とした場所へ移動(&amp;M)</translation>
    </message>
    <message>
        <source>Sends the selected robot to the chosen place</source>
        <translation>選択中のロボットを選んだ場所へ送る</translation>
    </message>
    <message>
        <source>Go there</source>
        <translation>移動</translation>
    </message>
    <message>
        <source>Show what was missed on the ma&amp;p</source>
        <translation>見落としを地図に表示(&amp;P)</translation>
    </message>
    <message>
        <source>Moves the map to the chosen place</source>
        <translation>選んだ場所へ地図を移動</translation>
    </message>
    <message>
        <source>Show</source>
        <translation>表示</translation>
    </message>
    <message>
        <source>Choose a place in the list of what was missed</source>
        <translation>見落としの一覧から場所を選択</translation>
    </message>
</context>
<context>
    <name>leitstand::DecisionText</name>
    <message>
        <source>scan %1 accepted</source>
        <translation>スキャン %1 の採用</translation>
    </message>
    <message>
        <source>%1 scans accepted</source>
        <translation>スキャン %1 件の採用</translation>
    </message>
    <message>
        <source>scan %1 set aside</source>
        <translation>スキャン %1 の除外</translation>
    </message>
    <message>
        <source>%1 scans set aside</source>
        <translation>スキャン %1 件の除外</translation>
    </message>
    <message>
        <source>scan %1 tried again</source>
        <translation>スキャン %1 の再試行</translation>
    </message>
    <message>
        <source>%1 scans tried again</source>
        <translation>スキャン %1 件の再試行</translation>
    </message>
    <message>
        <source>what belongs into the map</source>
        <translation>地図に含める範囲</translation>
    </message>
    <message>
        <source>%1 as corrected in a review</source>
        <comment>V1</comment>
        <translation>レビューで修正した %1</translation>
    </message>
    <message>
        <source>a note of a review</source>
        <translation>レビューのメモ</translation>
    </message>
    <message>
        <source>a closed loop</source>
        <translation>閉じたループ</translation>
    </message>
    <message>
        <source>two places kept apart</source>
        <translation>別の場所と判断した場所</translation>
    </message>
    <message>
        <source>the tidied map</source>
        <translation>整えた地図</translation>
    </message>
</context>
<context>
    <name>leitstand::DecisionsFeature</name>
    <message>
        <source>Ne&amp;xt doubtful scan</source>
        <translation>次の疑わしいスキャン(&amp;X)</translation>
    </message>
    <message>
        <source>Goes to the newest scan that waits for a decision, then to older ones</source>
        <translation>判断待ちの最新スキャンへ移動、続いて古いものへ</translation>
    </message>
    <message>
        <source>&amp;Accept scan</source>
        <translation>スキャンを採用(&amp;A)</translation>
    </message>
    <message>
        <source>The chosen scan counts where it stands</source>
        <translation>選択したスキャンを現在の位置で採用</translation>
    </message>
    <message>
        <source>Re&amp;ject scan</source>
        <translation>スキャンを除外(&amp;J)</translation>
    </message>
    <message>
        <source>The chosen scan is set aside: neither shown nor used</source>
        <translation>選択したスキャンを除外: 表示も使用もしない</translation>
    </message>
    <message>
        <source>Re&amp;try scan</source>
        <translation>スキャンを再試行(&amp;T)</translation>
    </message>
    <message>
        <source>Registers the chosen scan again, with the search chosen below</source>
        <translation>下で選んだ探索範囲で、選択したスキャンを再度位置合わせ</translation>
    </message>
    <message>
        <source>Retry from a &amp;pose</source>
        <translation>位置を指定して再試行(&amp;P)</translation>
    </message>
    <message>
        <source>Click on the map where the robot was, drag its heading: the chosen scan is registered again from there</source>
        <translation>地図上でロボットの位置をクリックし、ドラッグで向きを指定: そこから選択したスキャンを再度位置合わせ</translation>
    </message>
    <message>
        <source>Re&amp;wind to here</source>
        <translation>ここまで巻き戻す(&amp;W)</translation>
    </message>
    <message>
        <source>Sets aside all scans that entered after the chosen one</source>
        <translation>選択したスキャンより後に追加されたスキャンをすべて除外</translation>
    </message>
    <message>
        <source>&amp;Undo decision</source>
        <translation>判断を取り消す(&amp;U)</translation>
    </message>
    <message>
        <source>There is no such decision on the map</source>
        <translation>地図にそのような判断はない</translation>
    </message>
    <message>
        <source>Redo decision</source>
        <translation>判断をやり直す</translation>
    </message>
    <message>
        <source>Next ?</source>
        <translation>次の ?</translation>
    </message>
    <message>
        <source>Accept</source>
        <translation>採用</translation>
    </message>
    <message>
        <source>Reject</source>
        <translation>除外</translation>
    </message>
    <message>
        <source>Retry</source>
        <translation>再試行</translation>
    </message>
    <message>
        <source>From pose</source>
        <translation>位置指定</translation>
    </message>
    <message>
        <source>Rewind</source>
        <translation>巻き戻し</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>取り消し</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>やり直し</translation>
    </message>
    <message>
        <source>Draw map&apos;s a&amp;rea</source>
        <translation>地図の領域を描く(&amp;R)</translation>
    </message>
    <message>
        <source>Click the corners of what belongs into the map, a double click ends: points of coming scans outside of it stay out</source>
        <translation>地図に含める範囲の角をクリック、ダブルクリックで終了: 以後のスキャンでは範囲外の点を除く</translation>
    </message>
    <message>
        <source>Map e&amp;verything</source>
        <translation>すべてを地図に含める(&amp;V)</translation>
    </message>
    <message>
        <source>Nothing is outside of the map&apos;s area any more</source>
        <translation>地図の領域制限を解除</translation>
    </message>
    <message>
        <source>Draw area</source>
        <translation>領域を描く</translation>
    </message>
    <message>
        <source>Everything</source>
        <translation>すべて</translation>
    </message>
    <message>
        <source>No scan waits for a decision</source>
        <translation>判断待ちのスキャンなし</translation>
    </message>
    <message>
        <source>Click where the robot was at scan %1, drag its heading · right button: not at all</source>
        <translation>スキャン %1 時のロボット位置をクリック、ドラッグで向きを指定 · 右ボタン: 中止</translation>
    </message>
    <message>
        <source>Click the corners of what belongs into the map, double click the last one · right button: takes a corner back</source>
        <translation>地図に含める範囲の角をクリック、最後の角はダブルクリック · 右ボタン: 角を 1 つ戻す</translation>
    </message>
    <message>
        <source>Takes back: %1</source>
        <translation>取り消す判断: %1</translation>
    </message>
    <message>
        <source>&amp;Undo: %1</source>
        <translation>取り消し(&amp;U): %1</translation>
    </message>
    <message>
        <source>Decides again: %1</source>
        <translation>やり直す判断: %1</translation>
    </message>
    <message>
        <source>Redo: %1</source>
        <translation>やり直し: %1</translation>
    </message>
    <message>
        <source>The whole world belongs into the map</source>
        <translation>すべてを地図に含める</translation>
    </message>
    <message>
        <source>What is outside the dashed line stays out of the map</source>
        <translation>破線の外側は地図に含めない</translation>
    </message>
    <message>
        <source>Show a place that it &amp;meets</source>
        <translation>一致する場所を示す(&amp;M)</translation>
    </message>
    <message>
        <source>Click on the map where the robot was at the chosen scan by an older part of the map, drag its heading: where it fits there, the map asks whether it is the same place</source>
        <translation>選んだスキャンの時にロボットがいた場所を、地図の古い部分の上でクリックし、向きをドラッグします。そこに合えば、同じ場所かどうかを地図が尋ねます</translation>
    </message>
    <message>
        <source>Meets…</source>
        <translation>一致…</translation>
    </message>
    <message>
        <source>Click where the older part of the map has the place of scan %1, drag the robot&apos;s heading · right button: not at all</source>
        <translation>スキャン %1 の場所を地図の古い部分の上でクリックし、ロボットの向きをドラッグ · 右ボタン: 中止</translation>
    </message>
</context>
<context>
    <name>leitstand::DecisionsPanel</name>
    <message>
        <source>Nothing above</source>
        <translation>高さ上限</translation>
    </message>
    <message>
        <source>m</source>
        <translation>m</translation>
    </message>
    <message>
        <source>Scans and decisions</source>
        <translation>スキャンと判断</translation>
    </message>
    <message>
        <source>Key scans of the map, newest first</source>
        <translation>地図のキースキャン（新しい順）</translation>
    </message>
    <message>
        <source>Retry with</source>
        <translation>再試行条件</translation>
    </message>
    <message>
        <source>How far a retry searches</source>
        <translation>再試行の探索範囲</translation>
    </message>
    <message>
        <source>How far points may be from the map at first: wide finds a scan that is far off, narrow does not mistake one wall for another</source>
        <translation>最初に許す点と地図の距離: 広いと大きくずれたスキャンも見つかり、狭いと別の壁と取り違えにくい</translation>
    </message>
    <message>
        <source>wide search, 1.5 m</source>
        <translation>広い探索、1.5 m</translation>
    </message>
    <message>
        <source>widest search, 3 m</source>
        <translation>最も広い探索、3 m</translation>
    </message>
    <message>
        <source>usual search, 0.5 m</source>
        <translation>通常の探索、0.5 m</translation>
    </message>
    <message>
        <source>narrow search, 0.25 m</source>
        <translation>狭い探索、0.25 m</translation>
    </message>
    <message>
        <source>Points above this height, in the map&apos;s frame, are left out of the map: spectators, lamps, the hall&apos;s roof</source>
        <translation>地図座標系のこの高さより上の点を地図から除く: 観客、照明、屋根</translation>
    </message>
    <message>
        <source>Height above which nothing enters the map</source>
        <translation>地図に含める高さの上限</translation>
    </message>
    <message>
        <source>Choose a scan, or go to the newest doubtful one</source>
        <translation>スキャンを選択、または最新の疑わしいスキャンへ移動</translation>
    </message>
</context>
<context>
    <name>leitstand::DemoRobots</name>
    <message>
        <source>%1 cannot be started: %2</source>
        <translation>%1 を起動できない: %2</translation>
    </message>
    <message>
        <source>The simulated %1 has ended (%2): %3</source>
        <translation>シミュレーションの %1 が終了（%2）: %3</translation>
    </message>
</context>
<context>
    <name>leitstand::DriveFeature</name>
    <message>
        <source>The keys do not drive: %1 lets them</source>
        <translation>キーでは動きません。%1 でキー操縦にします</translation>
    </message>
    <message>
        <source>&amp;Drive with keys</source>
        <translation>キーで走行(&amp;D)</translation>
    </message>
    <message>
        <source>W S A D or the arrows drive the selected robot; Shift slow, Ctrl fast, Space halts, G held drives without eyes</source>
        <translation>W S A D または矢印で選択中のロボットを走行。Shift 低速、Ctrl 高速、Space 停止、G を押し続けると視界なし走行</translation>
    </message>
</context>
<context>
    <name>leitstand::DriveState</name>
    <message>
        <source>stop %1 · %2</source>
        <translation>停止 %1 · %2</translation>
    </message>
    <message>
        <source>takes no drive commands</source>
        <translation>走行指令を受け付けない</translation>
    </message>
    <message>
        <source>does not hear drive commands</source>
        <translation>走行指令を受信していない</translation>
    </message>
    <message>
        <source>the sticks are not on this robot</source>
        <translation>スティックは別のロボット</translation>
    </message>
    <message>
        <source>sticks must be neutral first</source>
        <translation>先にスティックを中立へ</translation>
    </message>
    <message>
        <source>you drive</source>
        <translation>操縦中</translation>
    </message>
    <message>
        <source>ready: you have the sticks</source>
        <translation>準備完了: 操縦可能</translation>
    </message>
    <message>
        <source>m/s</source>
        <translation>m/s</translation>
    </message>
    <message>
        <source>°/s</source>
        <translation>°/s</translation>
    </message>
    <message>
        <source>m</source>
        <translation>m</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 / %2</translation>
    </message>
    <message>
        <source>chains %1 · %2 m/s</source>
        <translation>履帯 %1 · %2 m/s</translation>
    </message>
    <message>
        <source>the chains do not follow</source>
        <translation>左右の履帯が追従しない</translation>
    </message>
    <message>
        <source>the left chain does not follow</source>
        <translation>左の履帯が追従しない</translation>
    </message>
    <message>
        <source>the right chain does not follow</source>
        <translation>右の履帯が追従しない</translation>
    </message>
    <message>
        <source>tips at %1</source>
        <translation>転倒限界 %1</translation>
    </message>
    <message>
        <source>tips at %1 · %2</source>
        <translation>転倒限界 %1 · %2</translation>
    </message>
    <message>
        <source>no attitude</source>
        <translation>姿勢データなし</translation>
    </message>
    <message>
        <source>roll %1 · pitch %2</source>
        <translation>ロール %1 · ピッチ %2</translation>
    </message>
    <message>
        <source>%</source>
        <translation>%</translation>
    </message>
    <message>
        <source>not reported</source>
        <translation>通知なし</translation>
    </message>
    <message>
        <source>V</source>
        <translation>V</translation>
    </message>
    <message>
        <source>charging</source>
        <translation>充電中</translation>
    </message>
    <message>
        <source>ppm</source>
        <translation>ppm</translation>
    </message>
    <message>
        <source>not fitted</source>
        <translation>非搭載</translation>
    </message>
    <message>
        <source>last 2 min · alarm at %1</source>
        <translation>直近 2 min · 警報 %1</translation>
    </message>
    <message>
        <source>no data yet</source>
        <translation>データ未着</translation>
    </message>
    <message>
        <source>%1 requests drive control</source>
        <translation>%1 が操縦権を要求</translation>
    </message>
    <message>
        <source>drive control: yours</source>
        <translation>操縦権あり</translation>
    </message>
    <message>
        <source>%1 keeps it</source>
        <translation>%1 が拒否</translation>
    </message>
    <message>
        <source>requested: listens for others</source>
        <translation>要求中: 他の応答を確認</translation>
    </message>
    <message>
        <source>requested: waits for %1</source>
        <translation>要求中: %1 を待機</translation>
    </message>
    <message>
        <source>%1 took over</source>
        <translation>%1 が引き継いだ</translation>
    </message>
    <message>
        <source>drive control: free</source>
        <translation>操縦権保持者なし</translation>
    </message>
    <message>
        <source>%1 has it, but is silent</source>
        <translation>%1 が保持、ただし応答なし</translation>
    </message>
    <message>
        <source>%1 drives</source>
        <translation>%1 が操縦中</translation>
    </message>
    <message>
        <source>%1 min</source>
        <translation>%1 min</translation>
    </message>
    <message>
        <source>%1 h</source>
        <translation>%1 h</translation>
    </message>
    <message>
        <source>%1 at this load</source>
        <translation>この負荷で %1</translation>
    </message>
    <message>
        <source>%1 · %2 m/s</source>
        <translation>%1 · %2 m/s</translation>
    </message>
    <message>
        <source>standing · hold the button of robot %1 for 1 s to release</source>
        <translation>静止 · ロボット %1 のボタンを 1 秒押し続けて解除</translation>
    </message>
</context>
<context>
    <name>leitstand::EnergyCell</name>
    <message>
        <source>Battery and link</source>
        <translation>バッテリーと通信</translation>
    </message>
    <message>
        <source>Battery %1 %2, %3
Link: %4 %5</source>
        <translation>バッテリー %1 %2、%3
通信: %4 %5</translation>
    </message>
    <message>
        <source>Battery</source>
        <translation>バッテリー</translation>
    </message>
    <message>
        <source>Link</source>
        <translation>通信</translation>
    </message>
</context>
<context>
    <name>leitstand::Error</name>
    <message>
        <source>{}: cannot be started: {}</source>
        <translation>{}: 起動できません: {}</translation>
    </message>
    <message>
        <source>leitstand-guard has ended</source>
        <translation>leitstand-guard が終了しました</translation>
    </message>
    <message>
        <source>{}: is of other key scans than the mission has now; register again</source>
        <translation>{}: 現在のミッションとは別のキースキャンのもの。もう一度レジストレーションしてください</translation>
    </message>
    <message>
        <source>{}: expected the name of a layout ({})</source>
        <translation>{}: レイアウト名が必要 ({})</translation>
    </message>
    <message>
        <source>&quot;{}&quot;: expected a name of letters, digits, _ and -</source>
        <translation>&quot;{}&quot;: 名前は英数字、_、- のみ</translation>
    </message>
    <message>
        <source>{}: expected a layout of one&apos;s own</source>
        <translation>{}: 自分のレイアウトが必要</translation>
    </message>
    <message>
        <source>{}: cannot be written: {}</source>
        <translation>{}: 書き込めません: {}</translation>
    </message>
    <message>
        <source>{}: is no picture that can be printed</source>
        <translation>{}: 印刷できる画像ではありません</translation>
    </message>
    <message>
        <source>{}: expected a label for each point</source>
        <translation>{}: 各点にラベルが必要</translation>
    </message>
    <message>
        <source>{}: cannot be opened</source>
        <translation>{}: 開けません</translation>
    </message>
    <message>
        <source>{}: expected %PDF at its beginning</source>
        <translation>{}: 先頭に %PDF が必要</translation>
    </message>
    <message>
        <source>{}: expected its table of objects at the end</source>
        <translation>{}: 末尾にオブジェクト表が必要</translation>
    </message>
    <message>
        <source>{}: its table of objects is not where it says</source>
        <translation>{}: オブジェクト表が示された位置にありません</translation>
    </message>
    <message>
        <source>{}: is no file of a report</source>
        <translation>{}: レポートのファイルではありません</translation>
    </message>
    <message>
        <source>{}: no report: {}</source>
        <translation>{}: レポートなし: {}</translation>
    </message>
    <message>
        <source>event {} is not in the log</source>
        <translation>イベント {} はログにありません</translation>
    </message>
    <message>
        <source>event {} ({}) cannot be read</source>
        <translation>イベント {} ({}) は読めません</translation>
    </message>
    <message>
        <source>another station has it in its log</source>
        <translation>別のステーションのログにあります</translation>
    </message>
    <message>
        <source>{}: the report was cancelled</source>
        <translation>{}: レポートは中止されました</translation>
    </message>
    <message>
        <source>{}: cannot be made: {}</source>
        <translation>{}: 作成できません: {}</translation>
    </message>
    <message>
        <source>{}: there is nothing in it</source>
        <translation>{}: 中身がありません</translation>
    </message>
    <message>
        <source>{}: {} of {} scans have no odometry within half a second of their stamp</source>
        <translation>{}: {} / {} スキャンには時刻の前後 0.5 秒にオドメトリがありません</translation>
    </message>
    <message>
        <source>{}: nobody tells where frame &quot;{}&quot; sits (neither tf_static nor the robot&apos;s file); taken as {}</source>
        <translation>{}: フレーム &quot;{}&quot; の位置が不明 (tf_static にもロボットのファイルにもなし)。{} とみなします</translation>
    </message>
    <message>
        <source>{}: its file names no {} stream</source>
        <translation>{}: ファイルにストリーム {} がありません</translation>
    </message>
    <message>
        <source>{}: the folder could not be made: {}</source>
        <translation>{}: フォルダーを作成できませんでした: {}</translation>
    </message>
    <message>
        <source>The gamepad {} cannot be used: {}</source>
        <translation>ゲームパッド {} は使えません: {}</translation>
    </message>
    <message>
        <source>Gamepads cannot be used: {}</source>
        <translation>ゲームパッドは使えません: {}</translation>
    </message>
    <message>
        <source>{}: is missing or cannot be read; the files were asked instead</source>
        <translation>{}: ないか読めないため、ファイルから調べました</translation>
    </message>
    <message>
        <source>{}: expected at most {} bytes, found {}</source>
        <translation>{}: 最大 {} バイトのはずが {} バイト</translation>
    </message>
    <message>
        <source>{}: cannot be opened: {}</source>
        <translation>{}: 開けません: {}</translation>
    </message>
    <message>
        <source>{}: expected a bag&apos;s folder or file, found nothing</source>
        <translation>{}: バッグのフォルダーかファイルが必要ですが、何もありません</translation>
    </message>
    <message>
        <source>{}: expected a folder or a regular file</source>
        <translation>{}: フォルダーか通常のファイルが必要</translation>
    </message>
    <message>
        <source>{}: expected it, since metadata.yaml lists it, found nothing</source>
        <translation>{}: metadata.yaml にありますが、見つかりません</translation>
    </message>
    <message>
        <source>{}: table messages: is damaged</source>
        <translation>{}: 表 messages が壊れています</translation>
    </message>
    <message>
        <source>{}: cannot be read on while it is written</source>
        <translation>{}: 書き込み中のため続きを読めません</translation>
    </message>
    <message>
        <source>{}: messages of topic number {}: expected it in the table topics</source>
        <translation>{}: トピック番号 {} のメッセージ: 表 topics にありません</translation>
    </message>
    <message>
        <source>{}: topic {}: expected serialization &quot;cdr&quot;, found &quot;{}&quot;</source>
        <translation>{}: トピック {}: シリアライズは &quot;cdr&quot; のはずが &quot;{}&quot;</translation>
    </message>
    <message>
        <source>{}; and no page of it holds messages, either</source>
        <translation>{}。メッセージのあるページもありません</translation>
    </message>
    <message>
        <source>{}; read page by page: {} messages found</source>
        <translation>{}。ページごとに読み込み: メッセージ {} 件</translation>
    </message>
    <message>
        <source>{}: messages {} to {}: expected in a page of the table messages, found nowhere (or never written)</source>
        <translation>{}: メッセージ {}～{}: 表 messages のページに見つかりません (または未書き込み)</translation>
    </message>
    <message>
        <source>{}: and further gaps</source>
        <translation>{}: ほかにも欠落あり</translation>
    </message>
    <message>
        <source>expected an SQLite database</source>
        <translation>SQLite データベースが必要</translation>
    </message>
    <message>
        <source>{}: expected the tables topics and messages of a rosbag2 bag</source>
        <translation>{}: rosbag2 バッグの表 topics と messages が必要</translation>
    </message>
    <message>
        <source>table {}</source>
        <translation>表 {}</translation>
    </message>
    <message>
        <source>{}: table messages: expected ids from 1 to {}, found {} to {}</source>
        <translation>{}: 表 messages: 番号は 1～{} のはずが {}～{}</translation>
    </message>
    <message>
        <source>{}: expected a robot&apos;s file, found none</source>
        <translation>{}: ロボットのファイルが必要ですが、ありません</translation>
    </message>
    <message>
        <source>{}: expected a robot&apos;s file, or the name {}, found none{}</source>
        <translation>{}: ロボットのファイルか名前 {} が必要ですが、ありません{}</translation>
    </message>
    <message>
        <source>picture: expected 1 to {} pixels a side and at most {}, found {} x {}</source>
        <translation>画像: 一辺 1～{} 画素、最大 {} 画素のはずが {} x {}</translation>
    </message>
    <message>
        <source>picture: encoding &quot;{}&quot; cannot be shown</source>
        <translation>画像: エンコーディング &quot;{}&quot; は表示できません</translation>
    </message>
    <message>
        <source>picture: expected {} rows of at least {} bytes, found {} bytes, {} a row</source>
        <translation>画像: {} 行、1 行 {} バイト以上のはずが {} バイト、1 行 {} バイト</translation>
    </message>
    <message>
        <source>picture: expected at least 3 x 3 pixels of a Bayer pattern</source>
        <translation>画像: ベイヤー配列は 3 x 3 画素以上必要</translation>
    </message>
    <message>
        <source>picture: expected pairs of pixels in a row, found {}</source>
        <translation>画像: 1 行は 2 画素の組のはずが {} 画素</translation>
    </message>
    <message>
        <source>picture: {}</source>
        <translation>画像: {}</translation>
    </message>
    <message>
        <source>picture: expected a file of less than 2 GB</source>
        <translation>画像: 2 GB 未満のファイルが必要</translation>
    </message>
    <message>
        <source>picture: the file of {} bytes is damaged</source>
        <translation>画像: {} バイトのファイルは壊れています</translation>
    </message>
    <message>
        <source>picture: {} channels cannot be shown</source>
        <translation>画像: {} チャンネルは表示できません</translation>
    </message>
    <message>
        <source>thermal picture: its colours are mapped and tell no temperature</source>
        <translation>熱画像: 色付け済みのため温度は分かりません</translation>
    </message>
    <message>
        <source>thermal picture: expected one number a pixel, found colours</source>
        <translation>熱画像: 1 画素 1 数値のはずが色です</translation>
    </message>
    <message>
        <source>picture: expected pixels to write, found none</source>
        <translation>画像: 書き込む画素がありません</translation>
    </message>
    <message>
        <source>picture: expected 8 or 16 bits a value, found 32, which PNG does not have</source>
        <translation>画像: 1 値 8 または 16 ビットのはずが 32 ビットで、PNG にはありません</translation>
    </message>
    <message>
        <source>picture: it could not be encoded as PNG</source>
        <translation>画像: PNG に変換できませんでした</translation>
    </message>
    <message>
        <source>release: this station does not hold the grant to drive</source>
        <translation>解除: このステーションには操縦権がありません</translation>
    </message>
    <message>
        <source>release: the robot has not reported its stop yet</source>
        <translation>解除: ロボットはまだ停止状態を伝えていません</translation>
    </message>
    <message>
        <source>release: the robot has not acknowledged the stop yet</source>
        <translation>解除: ロボットはまだ停止を確認していません</translation>
    </message>
    <message>
        <source>{}: expected a map of rosbag2&apos;s metadata</source>
        <translation>{}: rosbag2 のメタデータが必要</translation>
    </message>
    <message>
        <source>{}: expected {} with a storage_identifier</source>
        <translation>{}: {} に storage_identifier が必要</translation>
    </message>
    <message>
        <source>{}: expected rosbag2&apos;s metadata: {}</source>
        <translation>{}: rosbag2 のメタデータが必要: {}</translation>
    </message>
    <message>
        <source>{}: message {} on page {}: expected {} bytes, found fewer</source>
        <translation>{}: メッセージ {} (ページ {}): {} バイトのはずが足りません</translation>
    </message>
    <message>
        <source>{}: table {}</source>
        <translation>{}: 表 {}</translation>
    </message>
    <message>
        <source>{}: expected {} entries, found {}</source>
        <translation>{}: {} 件のはずが {} 件</translation>
    </message>
    <message>
        <source>{}: expected {} x {} pixels, found {} x {}</source>
        <translation>{}: {} x {} 画素のはずが {} x {}</translation>
    </message>
    <message>
        <source>{}: expected its corner at x {:g}, y {:g} m with pixels of {:g} m, found x {:g}, y {:g} m with {:g} m</source>
        <translation>{}: 角は x {:g}, y {:g} m、画素 {:g} m のはずが x {:g}, y {:g} m、{:g} m</translation>
    </message>
    <message>
        <source>{}: expected at least {} pages, found {}</source>
        <translation>{}: 少なくとも {} ページのはずが {} でした</translation>
    </message>
    <message>
        <source>{}: cannot be written: it is not a regular file</source>
        <translation>{}: 書き込めません: 通常のファイルではありません</translation>
    </message>
    <message>
        <source>expected either a button or an axis, found both</source>
        <translation>button か axis の一方のはずが、両方あります</translation>
    </message>
    <message>
        <source>expected either a button or an axis, found neither</source>
        <translation>button か axis の一方のはずが、どちらもありません</translation>
    </message>
    <message>
        <source>expected -1 or 1, the end to which the axis is pushed from its rest</source>
        <translation>-1 または 1 (静止位置から軸を倒す側) が必要</translation>
    </message>
    <message>
        <source>expected at most {} commands, found {}</source>
        <translation>コマンドは最大 {} 件のはずが {} 件</translation>
    </message>
    <message>
        <source>expected the command that the control does, found nothing</source>
        <translation>操作で行うコマンドが必要ですが、ありません</translation>
    </message>
    <message>
        <source>expected a command such as camera.recentre, found {}</source>
        <translation>camera.recentre のようなコマンドのはずが {}</translation>
    </message>
    <message>
        <source>{}: cannot be read</source>
        <translation>{}: 読み込めません</translation>
    </message>
    <message>
        <source>{}: its SHA-256 is not as {} says</source>
        <translation>{}: SHA-256 が {} の記載と異なります</translation>
    </message>
    <message>
        <source>{}: is not written: the position of {} is no number</source>
        <translation>{}: 書き込みません: {} の位置が数値ではありません</translation>
    </message>
    <message>
        <source>{}: cannot be written: expected a picture of RGB</source>
        <translation>{}: 書き込めません: RGB 画像が必要です</translation>
    </message>
    <message>
        <source>expected at most {:.0f} pixels, found {} x {}</source>
        <translation>最大 {:.0f} 画素のはずが {} x {} でした</translation>
    </message>
    <message>
        <source>expected three bands of 8 bits (24-bit RGB)</source>
        <translation>8 ビットのバンド 3 つ(24 ビット RGB)が必要です</translation>
    </message>
    <message>
        <source>expected a georeference</source>
        <translation>地理参照が必要です</translation>
    </message>
    <message>
        <source>expected square pixels, north up (a negative y pixel size)</source>
        <translation>正方形の画素、北が上(y 方向の画素サイズが負)が必要です</translation>
    </message>
    <message>
        <source>{}: is not written: the map is too far from its origin for an OctoMap</source>
        <translation>{}: 書き込みません: 地図が原点から遠すぎて OctoMap にできません</translation>
    </message>
    <message>
        <source>{}: cannot be written as an OctoMap</source>
        <translation>{}: OctoMap として書き込めません</translation>
    </message>
    <message>
        <source>{}: expected &quot;# Octomap OcTree binary file&quot; in its first line</source>
        <translation>{}: 最初の行に &quot;# Octomap OcTree binary file&quot; が必要です</translation>
    </message>
    <message>
        <source>{}: cannot be read as an OctoMap: expected a whole tree</source>
        <translation>{}: OctoMap として読み込めません: 完全な木が必要です</translation>
    </message>
    <message>
        <source>{}: cannot be read as an OctoMap: {}</source>
        <translation>{}: OctoMap として読み込めません: {}</translation>
    </message>
    <message>
        <source>{}: is not written: a figure of {} is no number</source>
        <translation>{}: 書き込みません: {} の値が数値ではありません</translation>
    </message>
    <message>
        <source>expected a name as in topics (letters, digits and _, not leitstand), found {}</source>
        <translation>トピックに使う名前 (英数字と _、leitstand 以外) のはずが {}</translation>
    </message>
    <message>
        <source>nothing</source>
        <translation>なし</translation>
    </message>
    <message>
        <source>expected one capital letter, found {}</source>
        <translation>英大文字 1 字のはずが {}</translation>
    </message>
    <message>
        <source>expected a frame such as base_link, without a slash before it and without blanks, found {}</source>
        <translation>base_link のようなフレーム (先頭の / と空白なし) のはずが {}</translation>
    </message>
    <message>
        <source>expected a list of corners, found {}</source>
        <translation>角のリストのはずが {}</translation>
    </message>
    <message>
        <source>expected [x, y], each from {} to {} m, found {}</source>
        <translation>[x, y] (各 {}～{} m) のはずが {}</translation>
    </message>
    <message>
        <source>expected a key or pad control of its own, found {}, which is that of {}</source>
        <translation>固有のキーまたはパッド操作のはずが、{} は {} に割り当て済み</translation>
    </message>
    <message>
        <source>expected stop, since nobody drives, found {}</source>
        <translation>操縦者がいないため stop のはずが {}</translation>
    </message>
    <message>
        <source>expected YAML, found a mistake: {}</source>
        <translation>YAML の誤り: {}</translation>
    </message>
    <message>
        <source>{}: expected a robot&apos;s file, found none that can be read</source>
        <translation>{}: ロボットのファイルが必要ですが、読めません</translation>
    </message>
    <message>
        <source>expected what the topic carries, such as points, found nothing</source>
        <translation>トピックの内容 (points など) が必要ですが、ありません</translation>
    </message>
    <message>
        <source>expected one stream of this role, found {} of line {} again</source>
        <translation>この役割のストリームは 1 つのはずが、{} ({} 行目) が重複</translation>
    </message>
    <message>
        <source>expected a topic of its own, found {} of line {} again</source>
        <translation>固有のトピックのはずが、{} ({} 行目) が重複</translation>
    </message>
    <message>
        <source>expected the camera that it belongs to, a name under sensors, found nothing</source>
        <translation>対応するカメラ (sensors の名前) が必要ですが、ありません</translation>
    </message>
    <message>
        <source>expected a name under sensors, which has none, found {}</source>
        <translation>sensors にある名前のはずが {} (sensors には名前なし)</translation>
    </message>
    <message>
        <source>expected {} (under sensors), found {}{}</source>
        <translation>{} (sensors の名前) のはずが {}{}</translation>
    </message>
    <message>
        <source>expected {} for {}, found {}{}</source>
        <translation>{} ({} の型) のはずが {}{}</translation>
    </message>
    <message>
        <source>expected a topic such as /kurt3d/odom (words of letters, digits and _ that begin with no digit), found {}</source>
        <translation>/kurt3d/odom のようなトピック (英数字と _ の語、先頭は数字以外) のはずが {}</translation>
    </message>
    <message>
        <source>expected a topic of the robot, found one of the stations: {}</source>
        <translation>ロボットのトピックのはずが、ステーションのトピック: {}</translation>
    </message>
    <message>
        <source>expected 0, since a stop never grows old, found &quot;{}&quot;</source>
        <translation>停止は古くならないため 0 のはずが &quot;{}&quot;</translation>
    </message>
    <message>
        <source>expected it only for commands that have a stamp, found it for {} of type {}</source>
        <translation>時刻付きの指令だけの項目ですが、{} (型 {}) にあります</translation>
    </message>
    <message>
        <source>expected it only for diagnostics, found it for {} of type {}</source>
        <translation>diagnostics だけの項目ですが、{} (型 {}) にあります</translation>
    </message>
    <message>
        <source>expected it only for thermal, found it for {} of type {}</source>
        <translation>thermal だけの項目ですが、{} (型 {}) にあります</translation>
    </message>
    <message>
        <source>expected a list of topics, found nothing</source>
        <translation>トピックのリストが必要ですが、ありません</translation>
    </message>
    <message>
        <source>expected one YAML document, found a second one</source>
        <translation>YAML 文書は 1 つのはずが、2 つ目があります</translation>
    </message>
    <message>
        <source>expected no alias, found one (*name)</source>
        <translation>エイリアス (*name) は使えません</translation>
    </message>
    <message>
        <source>expected no anchor, found one (&amp;name)</source>
        <translation>アンカー (&amp;name) は使えません</translation>
    </message>
    <message>
        <source>expected no tag, found {}</source>
        <translation>タグは使えませんが、{} があります</translation>
    </message>
    <message>
        <source>expected at most {} levels, found more</source>
        <translation>階層は最大 {} のはずが、超えています</translation>
    </message>
    <message>
        <source>expected UTF-8 text, found byte 0x{:02x}</source>
        <translation>UTF-8 テキストのはずが、バイト 0x{:02x} があります</translation>
    </message>
    <message>
        <source>expected spaces before the first word, found a tab</source>
        <translation>行頭は空白のはずが、タブがあります</translation>
    </message>
    <message>
        <source>{}: expected at most {} bytes, found more</source>
        <translation>{}: 最大 {} バイトのはずが、超えています</translation>
    </message>
    <message>
        <source>expected keys and values, found {}</source>
        <translation>キーと値のはずが {}</translation>
    </message>
    <message>
        <source>keys and values</source>
        <translation>キーと値</translation>
    </message>
    <message>
        <source>a list of {}</source>
        <translation>長さ {} のリスト</translation>
    </message>
    <message>
        <source>, did you mean {}?</source>
        <translation> ({} の間違い?)</translation>
    </message>
    <message>
        <source>{} or {}</source>
        <translation>{} または {}</translation>
    </message>
    <message>
        <source>{}: {} errors more</source>
        <translation>{}: ほかにエラー {} 件</translation>
    </message>
    <message>
        <source>expected one of the keys {}, found {}{}</source>
        <translation>キーは {} のはずが {}{}</translation>
    </message>
    <message>
        <source>expected a name of at most {} letters, digits and _ that begins with a letter, found {}</source>
        <translation>英字で始まる最大 {} 文字の名前 (英数字と _) のはずが {}</translation>
    </message>
    <message>
        <source>expected each key once, found {} of line {} again</source>
        <translation>キーは 1 回ずつのはずが、{} ({} 行目) が重複</translation>
    </message>
    <message>
        <source>expected a text of {} to {} printable characters, found {}</source>
        <translation>印字可能な {}～{} 文字のテキストのはずが {}</translation>
    </message>
    <message>
        <source>expected true or false, found {}</source>
        <translation>true または false のはずが {}</translation>
    </message>
    <message>
        <source>expected a number from {} to {}{}, found {}</source>
        <translation>{}～{}{} の数値のはずが {}</translation>
    </message>
    <message>
        <source>expected a whole number from {} to {}, found {}</source>
        <translation>{}～{} の整数のはずが {}</translation>
    </message>
    <message>
        <source>expected {} numbers from {} to {}{}, found {}</source>
        <translation>{} 個の数値 ({}～{}{}) のはずが {}</translation>
    </message>
    <message>
        <source>expected {}, found {}{}</source>
        <translation>{} のはずが {}{}</translation>
    </message>
    <message>
        <source>expected a list, found {}</source>
        <translation>リストのはずが {}</translation>
    </message>
    <message>
        <source>{}: expected limits of alarms, found no file that can be read</source>
        <translation>{}: 警報のしきい値が必要ですが、ファイルを読めません</translation>
    </message>
    <message>
        <source>is missing</source>
        <translation>ありません</translation>
    </message>
    <message>
        <source>expected x y z [m] and a quaternion x y z w of length 1</source>
        <translation>x y z [m] と長さ 1 の四元数 x y z w が必要</translation>
    </message>
    <message>
        <source>expected a distance [m] and a share from 0 to 1</source>
        <translation>距離 [m] と 0～1 の割合が必要</translation>
    </message>
    <message>
        <source>expected a count and two amounts, none below 0</source>
        <translation>個数と 2 つの量 (いずれも 0 以上) が必要</translation>
    </message>
    <message>
        <source>expected counts and amounts, none below 0, and no more wrong finds than finds</source>
        <translation>個数と量 (いずれも 0 以上)、誤った発見は発見の数以下が必要</translation>
    </message>
    <message>
        <source>stands in this file already</source>
        <translation>このファイルにすでにあります</translation>
    </message>
    <message>
        <source>expected distances above 0 and up to 1000 m</source>
        <translation>0 より大きく 1000 m 以下の距離が必要</translation>
    </message>
    <message>
        <source>expected at least one distance</source>
        <translation>距離が 1 つ以上必要</translation>
    </message>
    <message>
        <source>expected a list of key scans</source>
        <translation>キースキャンのリストが必要</translation>
    </message>
    <message>
        <source>{}: {} scans are more than it takes</source>
        <translation>{}: スキャン {} 件はファイルの上限を超えています</translation>
    </message>
    <message>
        <source>expected one of pane, horizontal and vertical</source>
        <translation>pane、horizontal、vertical のどれか 1 つが必要</translation>
    </message>
    <message>
        <source>expected letters, digits, _ . and -</source>
        <translation>使えるのは英数字、_ . - のみ</translation>
    </message>
    <message>
        <source>stands in this layout already</source>
        <translation>このレイアウトにすでにあります</translation>
    </message>
    <message>
        <source>expected a list of 2 to {} places</source>
        <translation>2～{} か所のリストが必要</translation>
    </message>
    <message>
        <source>expected keys and values</source>
        <translation>キーと値が必要</translation>
    </message>
    <message>
        <source>expected a command or button and its text</source>
        <translation>コマンドまたはボタンとそのテキストが必要</translation>
    </message>
    <message>
        <source>is too long, or stands here twice</source>
        <translation>長すぎるか、重複しています</translation>
    </message>
    <message>
        <source>expected the places of panes, found nothing</source>
        <translation>ペインの配置が必要ですが、ありません</translation>
    </message>
    <message>
        <source>expected what the window wrote here</source>
        <translation>ウィンドウが書き込んだ内容が必要</translation>
    </message>
    <message>
        <source>expected keys of this file</source>
        <translation>このファイルのキーが必要</translation>
    </message>
    <message>
        <source>expected at most 32 patterns such as &quot;V-#*&quot;</source>
        <translation>&quot;V-#*&quot; のようなパターンが必要 (最大 32 個)</translation>
    </message>
    <message>
        <source>expected JSON, found a mistake: {}</source>
        <translation>JSON の誤り: {}</translation>
    </message>
    <message>
        <source>{}: expected the rules of a score, found no file that can be read</source>
        <translation>{}: 採点規則が必要ですが、ファイルを読めません</translation>
    </message>
    <message>
        <source>expected 3 to {} corners, found {}</source>
        <translation>角は 3～{} 個のはずが {} 個</translation>
    </message>
    <message>
        <source>expected corners that differ, found [{}, {}] twice in a row</source>
        <translation>角は異なるはずが、[{}, {}] が 2 回続いています</translation>
    </message>
    <message>
        <source>expected sides that do not cross, found side {} crossing side {}</source>
        <translation>辺は交差しないはずが、辺 {} と辺 {} が交差</translation>
    </message>
    <message>
        <source>expected an area, found {:.3g} square metres</source>
        <translation>面積が必要ですが、{:.3g} 平方メートルです</translation>
    </message>
    <message>
        <source>{}: ends within what was being written: the last moment before is missing</source>
        <translation>{}: 書き込みの途中で終わっています。その直前の部分が欠けています</translation>
    </message>
    <message>
        <source>{}: its header is broken</source>
        <translation>{}: ヘッダーが壊れています</translation>
    </message>
    <message>
        <source>{}: frame {} is broken, {} follow</source>
        <translation>{}: フレーム {} が壊れています（後に {} 個）</translation>
    </message>
    <message>
        <source>{}: expected {} messages, as they were counted, found {}: {} are missing</source>
        <translation>{}: 記録時の数では {} 件のはずですが、見つかったのは {} 件です（{} 件が欠けています）</translation>
    </message>
    <message>
        <source>{}: and {} more messages with fewer bytes</source>
        <translation>{}: ほかに {} 件のメッセージでバイト数が足りません</translation>
    </message>
    <message>
        <source>{}-wal: expected it, since the writer of {} was cut off, found nothing: what was written last may be missing</source>
        <translation>{}-wal: {} の書き込みが途中で終わったので必要ですが、見つかりません。最後に書かれた部分が欠けている可能性があります</translation>
    </message>
    <message>
        <source>picture: expected at most {} bytes when it is decoded, found {}</source>
        <translation>画像: 展開後は最大 {} バイトのはずですが、{} です</translation>
    </message>
    <message>
        <source>picture: expected at most {} scans and {} pixels in all of them, found {} scans of {}</source>
        <translation>画像: スキャンは最大 {} 回、合計 {} 画素のはずですが、{} 回、各 {} 画素です</translation>
    </message>
    <message>
        <source>picture: PNG: expected a header of a known kind</source>
        <translation>画像: PNG: 既知の種類のヘッダーのはずです</translation>
    </message>
    <message>
        <source>picture: PNG: expected data of {} bytes for its pixels, found more</source>
        <translation>画像: PNG: 画素のデータは {} バイトのはずですが、それより多くあります</translation>
    </message>
    <message>
        <source>{}: write this below sensors, {}, by hand: {}</source>
        <translation>{}: sensors の {} の下に次の行を手で書いてください: {}</translation>
    </message>
    <message>
        <source>{}: has several scanners; scans of {} are taken (`maps: true` in its file names another)</source>
        <translation>{}: 複数のスキャナーがあります。{} のスキャンを使います (ファイルの `maps: true` で別のものを指定できます)</translation>
    </message>
    <message>
        <source>expected one stream that makes the map, found {} of line {} again</source>
        <translation>地図を作るストリームは 1 つだけですが、{} が {} 行目にもあります</translation>
    </message>
    <message>
        <source>environment variable {}: expected {}, found &quot;{}&quot;</source>
        <translation>環境変数 {}: {} が必要ですが、「{}」です</translation>
    </message>
    <message>
        <source>the folder of a keystore</source>
        <translation>キーストアのフォルダー</translation>
    </message>
    <message>
        <source>environment variable {}: with {} no robot can be found; unset it, or name a network card (--interface) or an address (--peer)</source>
        <translation>環境変数 {}: {} ではロボットが見つかりません。解除するか、ネットワークカード (--interface) またはアドレス (--peer) を指定してください</translation>
    </message>
    <message>
        <source>{}: no scans in it, expected a topic of sensor_msgs/msg/PointCloud2, or of sensor_msgs/msg/LaserScan with odometry{}</source>
        <translation>{}: スキャンがありません。sensor_msgs/msg/PointCloud2、またはオドメトリ付きの sensor_msgs/msg/LaserScan のトピックが必要です{}</translation>
    </message>
    <message>
        <source>expected it, found nothing</source>
        <translation>必要ですが、ありません</translation>
    </message>
    <message>
        <source>expected a map that is not turned, found a yaw of {:g}</source>
        <translation>回転していない地図が必要ですが、ヨー角が {:g} です</translation>
    </message>
    <message>
        <source>{}: expected a binary PGM (P5) with 8 bits a pixel</source>
        <translation>{}: 1 画素 8 ビットのバイナリ PGM (P5) が必要です</translation>
    </message>
    <message>
        <source>{}: expected at most {} pixels, found {} x {}</source>
        <translation>{}: 画素数は最大 {} ですが、{} x {} あります</translation>
    </message>
    <message>
        <source>{}: expected {} bytes of pixels, found {}</source>
        <translation>{}: 画素データは {} バイト必要ですが、{} バイトです</translation>
    </message>
    <message>
        <source>{}: cannot be read to its end</source>
        <translation>{}: 最後まで読み込めません</translation>
    </message>
    <message>
        <source>expected it only for points and ranges, found it for {} of type {}</source>
        <translation>points と ranges にのみ指定できますが、{}（型 {}）に指定されています</translation>
    </message>
    <message>
        <source>{}: expected a folder that does not exist yet</source>
        <translation>{}: まだ存在しないフォルダーが必要です</translation>
    </message>
    <message>
        <source>{}: is not written: cancelled</source>
        <translation>{}: 書き込みません: 中止されました</translation>
    </message>
    <message>
        <source>{}: byte 0: expected the beginning of an MCAP file</source>
        <translation>{}: バイト 0: MCAP ファイルの先頭が必要です</translation>
    </message>
    <message>
        <source>expected a chunk, found one that is cut off or broken</source>
        <translation>チャンクが必要ですが、途中で切れているか壊れています</translation>
    </message>
    <message>
        <source>expected a chunk compressed by zstd or lz4, found &quot;{}&quot;</source>
        <translation>zstd か lz4 で圧縮されたチャンクが必要ですが、「{}」です</translation>
    </message>
    <message>
        <source>the chunk is cut off; its beginning is read</source>
        <translation>チャンクが途中で切れています。先頭部分を読み込みます</translation>
    </message>
    <message>
        <source>expected a chunk of {} bytes, found {} that can be decompressed</source>
        <translation>{} バイトのチャンクが必要ですが、展開できるのは {} バイトです</translation>
    </message>
    <message>
        <source>the chunk is damaged: its checksum is wrong</source>
        <translation>チャンクが壊れています: チェックサムが一致しません</translation>
    </message>
    <message>
        <source>byte {}: {}</source>
        <translation>バイト {}: {}</translation>
    </message>
    <message>
        <source>message {}: expected a message where the index says, found none</source>
        <translation>メッセージ {}: 索引の示す位置にメッセージがありません</translation>
    </message>
    <message>
        <source>expected at most {} messages; those after them are left out</source>
        <translation>メッセージは最大 {} 件です。それ以降は省かれます</translation>
    </message>
    <message>
        <source>the file ends within this record: what follows is missing</source>
        <translation>ファイルがこのレコードの途中で終わっています。続きはありません</translation>
    </message>
    <message>
        <source>its writer did not finish it</source>
        <translation>書き込みが完了していません</translation>
    </message>
    <message>
        <source>expected at most {} topics</source>
        <translation>トピックは最大 {} 個です</translation>
    </message>
    <message>
        <source>{}: expected a bag&apos;s file, found an empty one</source>
        <translation>{}: バッグのファイルが必要ですが、空です</translation>
    </message>
    <message>
        <source>{}: expected a bag in SQLite or MCAP files (sqlite3, mcap), found storage &quot;{}&quot;; `ros2 bag convert` turns it into one</source>
        <translation>{}: SQLite か MCAP のバッグ (sqlite3、mcap) が必要ですが、ストレージは「{}」です。`ros2 bag convert` で変換できます</translation>
    </message>
    <message>
        <source>{}: expected a bag in SQLite or MCAP files (.db3, .mcap), found {}; `ros2 bag convert` turns it into one</source>
        <translation>{}: SQLite か MCAP のバッグ (.db3、.mcap) が必要ですが、{} です。`ros2 bag convert` で変換できます</translation>
    </message>
    <message>
        <source>{}: is of another kind than the bag&apos;s other files, and is not read</source>
        <translation>{}: バッグの他のファイルと種類が異なるため、読み込みません</translation>
    </message>
    <message>
        <source>{}: topic {}: expected messages compressed by zstd, found one that is damaged</source>
        <translation>{}: トピック {}: zstd で圧縮されたメッセージが必要ですが、壊れたものがあります</translation>
    </message>
    <message>
        <source>{}: is compressed twice</source>
        <translation>{}: 二重に圧縮されています</translation>
    </message>
    <message>
        <source>{}: expected a bag without compression, or with zstd, found compression &quot;{}&quot;; `ros2 bag convert` writes one without</source>
        <translation>{}: 圧縮なしか zstd のバッグが必要ですが、圧縮形式は「{}」です。`ros2 bag convert` で圧縮なしに変換できます</translation>
    </message>
    <message>
        <source>expected a file compressed by zstd, found one that is damaged</source>
        <translation>zstd で圧縮されたファイルが必要ですが、壊れています</translation>
    </message>
    <message>
        <source>{} cannot be written</source>
        <translation>{} に書き込めません</translation>
    </message>
    <message>
        <source>expected a file compressed by zstd, found one that is cut off</source>
        <translation>zstd で圧縮されたファイルが必要ですが、途中で切れています</translation>
    </message>
    <message>
        <source>{}: expected {} MB of free space in {} to unpack it, found {} MB; TMPDIR names another folder</source>
        <translation>{}: 展開には {} MB の空き容量が {} に必要ですが、{} MB しかありません。TMPDIR で別のフォルダーを指定できます</translation>
    </message>
    <message>
        <source>{}: cannot be unpacked in {}: {}</source>
        <translation>{}: {} に展開できません: {}</translation>
    </message>
    <message>
        <source>expected a type, found &quot;{}&quot;</source>
        <translation>型が必要ですが、「{}」です</translation>
    </message>
    <message>
        <source>{}: expected a text of at most {} bytes</source>
        <translation>{}: テキストは最大 {} バイトです</translation>
    </message>
    <message>
        <source>{}: its text lacks the type {}</source>
        <translation>{}: 定義に型 {} がありません</translation>
    </message>
    <message>
        <source>{}: expected a bag of ROS 1 in format 2.0</source>
        <translation>{}: ROS 1 のフォーマット 2.0 のバッグが必要です</translation>
    </message>
    <message>
        <source>expected a chunk compressed by bz2 or lz4, found &quot;{}&quot;</source>
        <translation>bz2 か lz4 で圧縮されたチャンクが必要ですが、「{}」です</translation>
    </message>
    <message>
        <source>{}: is not written: messages of {} were dropped</source>
        <translation>{}: 書き込みません: {} のメッセージが失われました</translation>
    </message>
    <message>
        <source>{}: cannot be copied: {}</source>
        <translation>{}: コピーできません: {}</translation>
    </message>
    <message>
        <source>{}: expected a folder outside of the bag</source>
        <translation>{}: バッグの外のフォルダーが必要です</translation>
    </message>
    <message>
        <source>expected a chunk of at most {} bytes, found {}</source>
        <translation>チャンクは最大 {} バイトですが、{} バイトです</translation>
    </message>
    <message>
        <source>{}: expected a bag: metadata.yaml and files that end in .db3, .mcap or .bag</source>
        <translation>{}: バッグ (metadata.yaml と、.db3、.mcap、.bag のいずれかで終わるファイル) が必要です</translation>
    </message>
    <message>
        <source>{}: is a copy of a mission in MCAP, without the numbers by which finds name their evidence: expected the mission itself</source>
        <translation>{}: MCAP に変換した任務のコピーで、発見の証拠を示す番号がありません。元の任務を指定してください</translation>
    </message>
    <message>
        <source>{}: is a copy of a mission in MCAP, for other programs: expected the mission itself</source>
        <translation>{}: 他のプログラム向けに MCAP に変換した任務のコピーです。元の任務を指定してください</translation>
    </message>
    <message>
        <source>expected a service such as /kurt3d/e_stop, found nothing</source>
        <translation>/kurt3d/e_stop のようなサービス名が必要ですが、ありません</translation>
    </message>
    <message>
        <source>expected a service such as /kurt3d/e_stop (words of letters, digits and _ that begin with no digit), found {}</source>
        <translation>/kurt3d/e_stop のようなサービス名（英字、数字、_ の語で、数字では始まらない）が必要ですが、{} でした</translation>
    </message>
    <message>
        <source>expected true, since a release gives no goals back, found false</source>
        <translation>解除しても目標は戻らないので true が必要ですが、false でした</translation>
    </message>
    <message>
        <source>expected a service of its own, found {} of line {} again</source>
        <translation>固有のサービスが必要ですが、{} は {} 行目と重複しています</translation>
    </message>
    <message>
        <source>{}: nobody offers its navigation {}</source>
        <translation>{}：ナビゲーション {} を提供するノードがありません</translation>
    </message>
    <message>
        <source>{}: its file names no service {}</source>
        <translation>{}：ファイルにサービス {} がありません</translation>
    </message>
    <message>
        <source>picture of depths: expected 16UC1 or 32FC1, found &quot;{}&quot;</source>
        <translation>深度画像: 16UC1 か 32FC1 のはずが &quot;{}&quot;</translation>
    </message>
    <message>
        <source>picture of depths: its camera_info holds no calibration that is known</source>
        <translation>深度画像: camera_info に既知の校正がありません</translation>
    </message>
    <message>
        <source>picture of depths: its RVL data are damaged</source>
        <translation>深度画像: RVL データが壊れています</translation>
    </message>
    <message>
        <source>picture of depths: expected at most {} pixels, found {} x {}</source>
        <translation>深度画像: 最大 {} 画素のはずが {} x {}</translation>
    </message>
    <message>
        <source>picture of depths: expected a PNG of 16 bits</source>
        <translation>深度画像: 16 ビットの PNG のはずです</translation>
    </message>
    <message>
        <source>picture of depths: expected at least {} bytes, found {}</source>
        <translation>深度画像: 少なくとも {} バイトのはずが {}</translation>
    </message>
    <message>
        <source>picture of depths: expected a PNG after 12 bytes, found {} other bytes (format &quot;{}&quot;)</source>
        <translation>深度画像: 12 バイトの後に PNG のはずが他の {} バイト (形式 &quot;{}&quot;)</translation>
    </message>
    <message>
        <source>picture: of a video, and damaged; waiting for the next key picture</source>
        <translation>画像: 動画の画像が壊れています。次のキーフレームを待っています</translation>
    </message>
    <message>
        <source>picture: of a video whose last key picture is missing or long ago: the encoder sends them too seldom (gop_size), or pictures are lost</source>
        <translation>画像: 動画の直近のキーフレームがないか古すぎます。エンコーダの間隔 (gop_size) が長すぎるか、画像が失われています</translation>
    </message>
    <message>
        <source>picture: of a video, expected at most {} pixels, found {}</source>
        <translation>画像: 動画は最大 {} 画素のはずが {}</translation>
    </message>
    <message>
        <source>picture: of a video that libavcodec does not decode here</source>
        <translation>画像: この動画は libavcodec で復号できません</translation>
    </message>
    <message>
        <source>expected a name of the group, of letters, digits and _, found {}</source>
        <translation>グループの名前（文字、数字、_）が必要ですが、{}でした</translation>
    </message>
    <message>
        <source>expected at most {}, found {}</source>
        <translation>{}以下が必要ですが、{}でした</translation>
    </message>
    <message>
        <source>expected a list of joints, found none</source>
        <translation>関節のリストが必要ですが、ありません</translation>
    </message>
    <message>
        <source>expected the name of a joint as in joint_states, found nothing</source>
        <translation>joint_statesにある関節の名前が必要ですが、ありません</translation>
    </message>
    <message>
        <source>expected each joint once, found {} again</source>
        <translation>関節は一度だけ書く必要がありますが、{}が再び書かれています</translation>
    </message>
    <message>
        <source>expected less than upper, {}{}, found {}</source>
        <translation>upper（{}{}）より小さい値が必要ですが、{}でした</translation>
    </message>
    <message>
        <source>expected lower and upper of a prismatic joint, found not both</source>
        <translation>直動関節にはlowerとupperの両方が必要ですが、そろっていません</translation>
    </message>
    <message>
        <source>expected how long it is, found nothing</source>
        <translation>長さが必要ですが、ありません</translation>
    </message>
    <message>
        <source>expected a joint that stands before it, found {}</source>
        <translation>それより前に書かれた関節が必要ですが、{}でした</translation>
    </message>
    <message>
        <source>expected one of the group&apos;s joints, each once, found {}</source>
        <translation>グループの関節を一度ずつ書く必要がありますが、{}でした</translation>
    </message>
    <message>
        <source>expected its title, found nothing</source>
        <translation>タイトルが必要ですが、ありません</translation>
    </message>
    <message>
        <source>expected {} positions, one for each joint, found none</source>
        <translation>関節ごとに一つ、{}個の位置が必要ですが、ありません</translation>
    </message>
    <message>
        <source>expected {} within its limits, found {}</source>
        <translation>{}は範囲内である必要がありますが、{}でした</translation>
    </message>
    <message>
        <source>expected a name of its own, found {} again</source>
        <translation>固有の名前が必要ですが、{}が再び使われています</translation>
    </message>
    <message>
        <source>expected a stream joint_command with the group {}, found none</source>
        <translation>グループ{}のjoint_commandストリームが必要ですが、ありません</translation>
    </message>
    <message>
        <source>expected it only for joint_command, found it for {}</source>
        <translation>joint_commandにだけ書けますが、{}に書かれています</translation>
    </message>
    <message>
        <source>expected the name of one of joint_groups, found {}{}</source>
        <translation>joint_groupsのいずれかの名前が必要ですが、{}でした{}</translation>
    </message>
    <message>
        <source>expected one stream for each group, found {} of line {} again</source>
        <translation>グループごとにストリームは一つですが、{}（{}行目）が再び書かれています</translation>
    </message>
    <message>
        <source>expected positions in a JointTrajectory, found a group that is commanded by velocity</source>
        <translation>JointTrajectoryには位置が必要ですが、速度で動かすグループでした</translation>
    </message>
    <message>
        <source>messages of type {} are not known, so nothing in them is read</source>
        <translation>{} 型のメッセージは未知のため、値を読み取れません</translation>
    </message>
    <message>
        <source>expected another number than 0</source>
        <translation>0 以外の数が必要です</translation>
    </message>
    <message>
        <source>expected another title for each number, found {} again</source>
        <translation>値ごとに異なる title が必要です。{} が重複しています</translation>
    </message>
    <message>
        <source>expected the path of a number in the message, such as temperature or cells[2].voltage, found {}</source>
        <translation>メッセージ内の数値のパス (例: temperature、cells[2].voltage) が必要です。{} が見つかりました</translation>
    </message>
    <message>
        <source>expected at least {} (that of {}), found &quot;{}&quot;</source>
        <translation>{} 以上 ({} の値) が必要です。&quot;{}&quot; が見つかりました</translation>
    </message>
    <message>
        <source>expected a list of numbers in messages of type {}, found nothing</source>
        <translation>{} 型のメッセージの数値のリストが必要ですが、ありません</translation>
    </message>
    <message>
        <source>expected 1 to {} numbers, found {}</source>
        <translation>1 から {} 個の数値が必要ですが、{} 個あります</translation>
    </message>
    <message>
        <source>expected it only for reading, found it for {}</source>
        <translation>reading にのみ指定できますが、{} に指定されています</translation>
    </message>
    <message>
        <source>{}: it came with the program, and neither HOME nor XDG_CONFIG_HOME tells where a copy goes</source>
        <translation>{}: プログラムに付属のファイルであり、HOME も XDG_CONFIG_HOME もコピー先を示していません</translation>
    </message>
    <message>
        <source>{}: write this by hand: footprint: {}, height: {}, and places of sensors</source>
        <translation>{}: 手で書き込んでください: footprint: {}、height: {}、およびセンサーの位置</translation>
    </message>
    <message>
        <source>expected a folder, at most {} of them, found {}</source>
        <translation>フォルダー (最大 {} 個) が必要ですが、{} でした</translation>
    </message>
    <message>
        <source>expected sequences of {} messages, found {}; the others are left out</source>
        <translation>{} 件のメッセージの番号が必要ですが、{} 件しかありません。残りは除かれます</translation>
    </message>
    <message>
        <source>{}: expected a sequence of its own for each message; {} are left out</source>
        <translation>{}: メッセージごとに異なる番号が必要です。{} 件は除かれます</translation>
    </message>
</context>
<context>
    <name>leitstand::EvidenceStrip</name>
    <message>
        <source>Pictures of the find</source>
        <translation>発見物の画像</translation>
    </message>
    <message>
        <source>reads the pictures…</source>
        <translation>画像を読み込み中…</translation>
    </message>
    <message>
        <source>no pictures</source>
        <translation>画像なし</translation>
    </message>
</context>
<context>
    <name>leitstand::FieldRowsModel</name>
    <message>
        <source>Field</source>
        <translation>フィールド</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>値</translation>
    </message>
    <message>
        <source>%1
A click plots it</source>
        <translation>%1
クリックでグラフ表示</translation>
    </message>
</context>
<context>
    <name>leitstand::FileCommands</name>
    <message>
        <source>%1 and %2 more</source>
        <translation>%1 ほか %2 件</translation>
    </message>
    <message>
        <source>&amp;Open scans…</source>
        <translation>スキャンを開く(&amp;O)…</translation>
    </message>
    <message>
        <source>Adds scan files to the map</source>
        <translation>スキャンファイルを地図に追加</translation>
    </message>
    <message>
        <source>Open &amp;folder…</source>
        <translation>フォルダを開く(&amp;F)…</translation>
    </message>
    <message>
        <source>Adds all scans of a folder to the map</source>
        <translation>フォルダ内の全スキャンを地図に追加</translation>
    </message>
    <message>
        <source>Open &amp;recent</source>
        <translation>最近使った項目(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;Save picture…</source>
        <translation>画像を保存(&amp;S)…</translation>
    </message>
    <message>
        <source>Saves the map as it is shown, in full detail</source>
        <translation>表示中の地図を最高精細で保存</translation>
    </message>
    <message>
        <source>&amp;Close scans</source>
        <translation>スキャンを閉じる(&amp;C)</translation>
    </message>
    <message>
        <source>Empties the map</source>
        <translation>地図を空にする</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>終了(&amp;Q)</translation>
    </message>
    <message>
        <source>Open scans</source>
        <translation>スキャンを開く</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>すべてのファイル (*)</translation>
    </message>
    <message>
        <source>Open a folder of scans</source>
        <translation>スキャンのフォルダを開く</translation>
    </message>
    <message>
        <source>Save the map&apos;s picture</source>
        <translation>地図の画像を保存</translation>
    </message>
    <message>
        <source>PNG pictures (*.png)</source>
        <translation>PNG 画像 (*.png)</translation>
    </message>
    <message>
        <source>JPEG pictures (*.jpg)</source>
        <translation>JPEG 画像 (*.jpg)</translation>
    </message>
    <message>
        <source>map.png</source>
        <translation>map.png</translation>
    </message>
    <message>
        <source>%1: the picture could not be written</source>
        <translation>%1: 画像を書き込めない</translation>
    </message>
    <message>
        <source>&amp;Forget these</source>
        <translation>履歴を消去(&amp;F)</translation>
    </message>
    <message>
        <source>Scans (%1)</source>
        <translation>スキャン (%1)</translation>
    </message>
</context>
<context>
    <name>leitstand::FindMoves</name>
    <message>
        <source>scans were registered again</source>
        <translation>スキャンの再位置合わせ</translation>
    </message>
    <message>
        <source>a loop was closed</source>
        <translation>ループの閉合</translation>
    </message>
    <message>
        <source>the operator corrected scans</source>
        <translation>オペレータによるスキャンの修正</translation>
    </message>
    <message>
        <source>a decision was taken back</source>
        <translation>操作の取り消し</translation>
    </message>
    <message>
        <source>moved %1 m at %2, since %3</source>
        <translation>%2 に %1 m 移動（理由: %3）</translation>
    </message>
    <message>
        <source>%1 %2 m</source>
        <comment>V1 0.32 m</comment>
        <translation>%1 %2 m</translation>
    </message>
    <message>
        <source>%1 moved, since %2</source>
        <translation>%1 移動（理由: %2）</translation>
    </message>
</context>
<context>
    <name>leitstand::FindPointing</name>
    <message>
        <source>Victim where I &amp;click</source>
        <translation>クリックした場所の被災者(&amp;C)</translation>
    </message>
    <message>
        <source>Then click on it in a picture, in the virtual scan or on the map; in pictures and the virtual scan a click with Shift does the same at any time</source>
        <translation>続けて画像、仮想スキャン、または地図上でクリック。画像と仮想スキャンでは Shift+クリックでいつでも同じ操作</translation>
    </message>
    <message>
        <source>Click where the victim is · right button: not at all</source>
        <translation>被災者の位置をクリック · 右ボタン: 中止</translation>
    </message>
    <message>
        <source>Click on the victim: in a picture, in the virtual scan or on the map</source>
        <translation>被災者をクリック: 画像、仮想スキャン、または地図上で</translation>
    </message>
    <message>
        <source>The robot is not in the map yet: nothing was filed</source>
        <translation>ロボットがまだ地図にない: 登録なし</translation>
    </message>
    <message>
        <source>Then click on it in a picture, in the virtual scan or on the map</source>
        <translation>続けて画像、仮想スキャン、または地図上でクリック</translation>
    </message>
    <message>
        <source>Hazard where I click</source>
        <translation>クリックした場所の危険物</translation>
    </message>
    <message>
        <source>QR code where I click</source>
        <translation>クリックした場所の QR コード</translation>
    </message>
    <message>
        <source>Object where I click</source>
        <translation>クリックした場所の物体</translation>
    </message>
    <message>
        <source>Click where it is · right button: not at all</source>
        <translation>位置をクリック · 右ボタン: 中止</translation>
    </message>
    <message>
        <source>Click on it: in a picture, in the virtual scan or on the map</source>
        <translation>クリック: 画像、仮想スキャン、または地図上で</translation>
    </message>
</context>
<context>
    <name>leitstand::FindRow</name>
    <message>
        <source>part of %1</source>
        <translation>%1 の一部</translation>
    </message>
    <message>
        <source>discarded</source>
        <translation>破棄</translation>
    </message>
    <message>
        <source>surface</source>
        <translation>地表</translation>
    </message>
    <message>
        <source>trapped</source>
        <translation>挟まれ</translation>
    </message>
    <message>
        <source>void</source>
        <translation>空隙</translation>
    </message>
    <message>
        <source>entombed</source>
        <translation>埋没</translation>
    </message>
</context>
<context>
    <name>leitstand::FindsByClick</name>
    <message>
        <source>Mo&amp;ve the find on the map</source>
        <translation>発見を地図上で移動(&amp;V)</translation>
    </message>
    <message>
        <source>Click on the map where the chosen find is</source>
        <translation>選択した発見の位置を地図上でクリック</translation>
    </message>
    <message>
        <source>Move</source>
        <translation>移動</translation>
    </message>
    <message>
        <source>Victim where I &amp;click</source>
        <translation>クリックした場所の被災者(&amp;C)</translation>
    </message>
    <message>
        <source>New</source>
        <translation>新規</translation>
    </message>
    <message>
        <source>Hazard where I click</source>
        <translation>クリックした場所の危険物</translation>
    </message>
    <message>
        <source>QR code where I click</source>
        <translation>クリックした場所の QR コード</translation>
    </message>
    <message>
        <source>Object where I click</source>
        <translation>クリックした場所の物体</translation>
    </message>
    <message>
        <source>Then click on it in a picture, in the virtual scan or on the map: filed with the pictures of this moment</source>
        <translation>続いて映像、仮想スキャン、または地図上でクリック。この時点の映像とともに登録</translation>
    </message>
    <message>
        <source>Click where %1 is · right button: not at all</source>
        <translation>%1 の位置をクリック · 右ボタン: 中止</translation>
    </message>
    <message>
        <source>%1 moved (as finished)</source>
        <translation>%1 を移動（最終状態）</translation>
    </message>
    <message>
        <source>Click where it is · right button: not at all</source>
        <translation>位置をクリック · 右ボタン: 中止</translation>
    </message>
    <message>
        <source>%1 filed (as finished)</source>
        <translation>%1 を登録（最終状態）</translation>
    </message>
    <message>
        <source>The robot was not in the map then: nothing was filed</source>
        <translation>その時点でロボットは地図上になかったため、登録していない</translation>
    </message>
</context>
<context>
    <name>leitstand::FindsFeature</name>
    <message>
        <source>Taken back</source>
        <translation>取り消した</translation>
    </message>
    <message>
        <source>Write a n&amp;ote…</source>
        <translation>メモを書く(&amp;O)…</translation>
    </message>
    <message>
        <source>About the moment that is shown</source>
        <translation>表示中の時点について</translation>
    </message>
    <message>
        <source>&amp;Undo what was written</source>
        <translation>記入を取り消す(&amp;U)</translation>
    </message>
    <message>
        <source>The mission took this find back later</source>
        <translation>この発見は後にミッション中に取り消された</translation>
    </message>
    <message>
        <source>%1: %2 (as finished)</source>
        <translation>%1: %2（終了時点）</translation>
    </message>
    <message>
        <source>%1 corrected (as finished)</source>
        <translation>%1 を訂正（終了時点）</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>メモ</translation>
    </message>
    <message>
        <source>About %1</source>
        <translation>%1 について</translation>
    </message>
    <message>
        <source>Noted at %1</source>
        <translation>%1 にメモ</translation>
    </message>
    <message>
        <source>Con&amp;firm the find</source>
        <translation>発見を確定(&amp;F)</translation>
    </message>
    <message>
        <source>Confirm</source>
        <translation>確定</translation>
    </message>
    <message>
        <source>&amp;Discard the find</source>
        <translation>発見を破棄(&amp;D)</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>破棄</translation>
    </message>
    <message>
        <source>Form of the f&amp;ind…</source>
        <translation>発見の用紙(&amp;I)…</translation>
    </message>
    <message>
        <source>Form…</source>
        <translation>用紙…</translation>
    </message>
    <message>
        <source>The chosen find&apos;s form: what is known of it</source>
        <translation>選んだ発見の用紙: 分かっていること</translation>
    </message>
    <message>
        <source>Note…</source>
        <translation>メモ…</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>元に戻す</translation>
    </message>
    <message>
        <source>&amp;Merge with the nearest</source>
        <translation>最寄りと統合(&amp;M)</translation>
    </message>
    <message>
        <source>Merge</source>
        <translation>統合</translation>
    </message>
    <message>
        <source>The chosen find is the same as the nearest one of its kind, which gets its evidence</source>
        <translation>選択した発見は最寄りの同種の発見と同一。証拠はそちらに移る</translation>
    </message>
    <message>
        <source>The chosen find is one; the chosen candidate is filed</source>
        <translation>選択した発見を確定。選択した候補は登録</translation>
    </message>
    <message>
        <source>The candidate is filed (as finished)</source>
        <translation>候補を登録（最終状態）</translation>
    </message>
    <message>
        <source>The chosen find, or candidate, is none</source>
        <translation>選択した発見または候補は誤認</translation>
    </message>
    <message>
        <source>The candidate is dismissed (as finished)</source>
        <translation>候補を却下（最終状態）</translation>
    </message>
    <message>
        <source>Takes back what was written last in reviews</source>
        <translation>レビューで最後に書いた内容を取り消す</translation>
    </message>
</context>
<context>
    <name>leitstand::FormPictures</name>
    <message>
        <source>%1, %2, %3</source>
        <translation>%1、%2、%3</translation>
    </message>
    <message>
        <source>%1: up to %2 °C</source>
        <translation>%1：最高 %2 °C</translation>
    </message>
</context>
<context>
    <name>leitstand::FrameRowsModel</name>
    <message>
        <source>Frame</source>
        <translation>座標系</translation>
    </message>
    <message>
        <source>x y z [m]</source>
        <translation>x y z [m]</translation>
    </message>
    <message>
        <source>Rate</source>
        <translation>頻度</translation>
    </message>
    <message>
        <source>Age</source>
        <translation>経過</translation>
    </message>
</context>
<context>
    <name>leitstand::FrameWords</name>
    <message>
        <source>It is above itself: tf uses no frame of such a circle</source>
        <translation>自分自身の上位にあります: tf はこのような循環の座標系を使えません</translation>
    </message>
    <message>
        <source>Also below %1: two nodes publish it, and tf jumps between both</source>
        <translation>%1 の下にもあります: 2 つのノードが発行しており、tf は両者の間で飛びます</translation>
    </message>
    <message>
        <source>The highest frame of a tree</source>
        <translation>ツリーの最上位の座標系</translation>
    </message>
    <message>
        <source>below %1</source>
        <translation>%1 の下</translation>
    </message>
    <message>
        <source>%1 m · roll %2, pitch %3, yaw %4</source>
        <translation>%1 m · ロール %2、ピッチ %3、ヨー %4</translation>
    </message>
    <message>
        <source>static</source>
        <translation>固定</translation>
    </message>
    <message>
        <source>%1 Hz</source>
        <translation>%1 Hz</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 秒</translation>
    </message>
    <message>
        <source>No transforms came</source>
        <translation>座標変換を受信していません</translation>
    </message>
    <message>
        <source>frames: %1</source>
        <translation>座標系: %1</translation>
    </message>
    <message>
        <source>trees that nothing connects: %1</source>
        <translation>つながっていないツリー: %1</translation>
    </message>
    <message>
        <source>with two parents or in a circle: %1</source>
        <translation>親が 2 つあるか循環しているもの: %1</translation>
    </message>
    <message>
        <source>No transforms lead from the base to %1: the places in the robot&apos;s file count</source>
        <translation>ベースから %1 への座標変換がありません: ロボットのファイルの位置を使います</translation>
    </message>
</context>
<context>
    <name>leitstand::FramesFeature</name>
    <message>
        <source>&amp;Frames of the robot (tf)</source>
        <translation>ロボットの座標系 (tf)(&amp;F)</translation>
    </message>
    <message>
        <source>The tree of its frames, where each lies in its parent, how often and when that came</source>
        <translation>座標系のツリー: 親の中での位置、受信の頻度と時刻</translation>
    </message>
</context>
<context>
    <name>leitstand::FramesPanel</name>
    <message>
        <source>Frames</source>
        <translation>座標系</translation>
    </message>
    <message>
        <source>Frames of the robot, each below its parent</source>
        <translation>ロボットの座標系 (親の下に表示)</translation>
    </message>
</context>
<context>
    <name>leitstand::Freshness</name>
    <message>
        <source>%1 ms</source>
        <translation>%1 ms</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>%1 min</source>
        <translation>%1 min</translation>
    </message>
    <message>
        <source>no data yet</source>
        <translation>データ未着</translation>
    </message>
    <message>
        <source>same for %1</source>
        <translation>同一映像 %1</translation>
    </message>
    <message>
        <source>the same picture for %1</source>
        <translation>%1 同じ映像</translation>
    </message>
    <message>
        <source>no data for %1</source>
        <translation>%1 データなし</translation>
    </message>
</context>
<context>
    <name>leitstand::GasCell</name>
    <message>
        <source>CO₂</source>
        <translation>CO₂</translation>
    </message>
    <message>
        <source>CO₂ %1 %2 %3
%4</source>
        <translation>CO₂ %1 %2 %3
%4</translation>
    </message>
</context>
<context>
    <name>leitstand::GoTo</name>
    <message>
        <source>&amp;Go to a place</source>
        <translation>地点へ移動(&amp;G)</translation>
    </message>
    <message>
        <source>Click where the selected robot shall go by itself, drag its heading; a double click on the floor does the same</source>
        <translation>選択中のロボットが自律で向かう地点をクリック、ドラッグで向きを指定。床のダブルクリックも同じ</translation>
    </message>
    <message>
        <source>%1 is not in the map yet</source>
        <translation>%1 はまだ地図にない</translation>
    </message>
    <message>
        <source>Click where %1 shall go, drag its heading · right button: not at all</source>
        <translation>%1 の行き先をクリック、ドラッグで向きを指定 · 右ボタン: 中止</translation>
    </message>
    <message>
        <source>%1 is not sent: it was halted</source>
        <translation>%1 を送り出さない: 停止された</translation>
    </message>
    <message>
        <source>%1 was not sent: its odometry restarted, and nobody knows where</source>
        <translation>%1 を送り出していない: オドメトリが初期化され、位置が不明</translation>
    </message>
    <message>
        <source>%1 was not sent: another station has its drive control</source>
        <translation>%1 を送り出していない: 操縦権は別の操作卓にある</translation>
    </message>
    <message>
        <source>%1 takes no goals</source>
        <translation>%1 は目標地点を受け付けない</translation>
    </message>
    <message>
        <source>%1: the map moved under its goal, which is withdrawn; send it again</source>
        <translation>%1: 目標の下で地図が動いたため、目標を取り消しました。もう一度送ってください</translation>
    </message>
    <message>
        <source>%1: its goal is cancelled, since it was halted</source>
        <translation>%1：停止させたため目標を取り消しました</translation>
    </message>
    <message>
        <source>%1: its goal is cancelled, since you drive</source>
        <translation>%1：手動運転のため目標を取り消しました</translation>
    </message>
    <message>
        <source>Go there &amp;next</source>
        <translation>次にそこへ(&amp;N)</translation>
    </message>
    <message>
        <source>Click where the selected robot shall go after the place that it is sent to now</source>
        <translation>選択中のロボットが今の目標の次に向かう場所をクリック</translation>
    </message>
    <message>
        <source>Return to &amp;start</source>
        <translation>出発点へ戻る(&amp;S)</translation>
    </message>
    <message>
        <source>Sends the selected robot to where its trail in the map begins</source>
        <translation>選択中のロボットを地図上の軌跡の始点へ送ります</translation>
    </message>
    <message>
        <source>Click where %1 shall go next, drag its heading · right button: not at all</source>
        <translation>%1 が次に向かう場所をクリック、向きをドラッグ · 右ボタン: 取消</translation>
    </message>
    <message>
        <source>%1 is sent to %2 places already</source>
        <translation>%1 はすでに %2 か所へ送られています</translation>
    </message>
    <message>
        <source>%1 has not driven yet: it has no start to return to</source>
        <translation>%1 はまだ走っていません。戻る出発点がありません</translation>
    </message>
    <message>
        <source>%1: where it was to go next is given up</source>
        <translation>%1: 次の目標を取り消しました</translation>
    </message>
</context>
<context>
    <name>leitstand::GoalQuestion</name>
    <message>
        <source>Send it to where its goal lies &amp;now</source>
        <translation>目標の現在の位置へ送る(&amp;N)</translation>
    </message>
    <message>
        <source>Leave its goal &amp;withdrawn</source>
        <translation>目標を取り消したままにする(&amp;W)</translation>
    </message>
    <message>
        <source>Send again</source>
        <translation>再送</translation>
    </message>
    <message>
        <source>Leave it</source>
        <translation>そのまま</translation>
    </message>
    <message>
        <source>No goal was withdrawn</source>
        <translation>取り消された目標はありません</translation>
    </message>
    <message>
        <source>%1: the map moved by %2 m under its goal, which is withdrawn. Send it to where that place lies now?</source>
        <translation>%1: 目標の下で地図が %2 m 動いたため、目標を取り消しました。その場所の現在の位置へ送りますか？</translation>
    </message>
</context>
<context>
    <name>leitstand::GoalText</name>
    <message>
        <source>sent to its goal</source>
        <translation>目標を送信</translation>
    </message>
    <message>
        <source>gives up its goal</source>
        <translation>目標を取り消し中</translation>
    </message>
    <message>
        <source>drives to its goal</source>
        <translation>目標へ移動中</translation>
    </message>
    <message>
        <source>%1 m to go</source>
        <translation>残り %1 m</translation>
    </message>
    <message>
        <source>%1 has arrived</source>
        <translation>%1 が到着しました</translation>
    </message>
    <message>
        <source>%1: its goal was cancelled</source>
        <translation>%1：目標は取り消されました</translation>
    </message>
    <message>
        <source>%1 gave up on the way to its goal</source>
        <translation>%1 は目標への途中で断念しました</translation>
    </message>
    <message>
        <source>%1 does not accept the goal</source>
        <translation>%1 は目標を受け付けません</translation>
    </message>
    <message>
        <source>%1 does not answer: the goal may not have reached it</source>
        <translation>%1 が応答しません。目標が届いていない可能性があります</translation>
    </message>
    <message>
        <source>stuck: %1</source>
        <comment>so often on its way</comment>
        <translation>立ち往生：%1</translation>
    </message>
</context>
<context>
    <name>leitstand::GridOnMap</name>
    <message>
        <source>Next map of the &amp;robot&apos;s own</source>
        <translation>ロボット自身の次の地図(&amp;R)</translation>
    </message>
    <message>
        <source>Grid maps and costmaps of the selected robot over the map, one after the other, then none</source>
        <translation>選択したロボットの格子地図とコストマップを地図に重ねて順に表示し、最後は非表示にします</translation>
    </message>
    <message>
        <source>%1 sends no map of its own</source>
        <translation>%1 は自身の地図を送信していません</translation>
    </message>
    <message>
        <source>%1: no map of its own is shown</source>
        <translation>%1：自身の地図は表示していません</translation>
    </message>
    <message>
        <source>%1: %2 is shown once the robot is in the map</source>
        <translation>%1：%2 はロボットが地図に入ると表示されます</translation>
    </message>
    <message>
        <source>%1: %2 is empty so far</source>
        <translation>%1：%2 はまだ空です</translation>
    </message>
    <message>
        <source>%1: %2 cannot be placed: no tf leads from &quot;%3&quot; to &quot;%4&quot;</source>
        <translation>%1：%2 を配置できません：「%3」から「%4」への tf がありません</translation>
    </message>
    <message>
        <source>%1: %2 is shown over the map</source>
        <translation>%1：%2 を地図に重ねて表示しています</translation>
    </message>
</context>
<context>
    <name>leitstand::HandInFeature</name>
    <message>
        <source>R&amp;eport into a folder…</source>
        <translation>フォルダーへ報告(&amp;E)…</translation>
    </message>
    <message>
        <source>Writes the judges&apos; folder of this mission, with what was corrected in the review</source>
        <translation>このミッションの審判用フォルダーを、レビューでの訂正を含めて書き出す</translation>
    </message>
    <message>
        <source>Folder for the report</source>
        <translation>報告書のフォルダー</translation>
    </message>
    <message>
        <source>Report: %1 %</source>
        <translation>報告書：%1 %</translation>
    </message>
    <message>
        <source>Report</source>
        <translation>報告書</translation>
    </message>
</context>
<context>
    <name>leitstand::Hearing</name>
    <message>
        <source>{}: {}; joining the network again</source>
        <translation>{}: {}。ネットワークに入り直します</translation>
    </message>
    <message>
        <source>announced by {}, but none of its topics are</source>
        <translation>{}が告知されていますが、トピックがありません</translation>
    </message>
    <message>
        <source>announced, but nothing comes: {}</source>
        <translation>告知されていますが、何も届きません: {}</translation>
    </message>
    <message>
        <source>{}: {}; is the sensor switched on?</source>
        <translation>{}: {}。センサーの電源は入っていますか？</translation>
    </message>
    <message>
        <source>{}: {}; joining again did not help: look at the robot&apos;s program, at firewalls, and at which networks both are in</source>
        <translation>{}: {}。再接続しても変わりません。ロボットのプログラム、ファイアウォール、両者のネットワークを確認してください</translation>
    </message>
    <message>
        <source>announced, but never came: {}</source>
        <translation>通知されているが一度も届いていません: {}</translation>
    </message>
</context>
<context>
    <name>leitstand::HelpCommands</name>
    <message>
        <source>Left button</source>
        <translation>左ボタン</translation>
    </message>
    <message>
        <source>turns the map; while measuring, picks a point</source>
        <translation>地図を回転。計測中は点を選択</translation>
    </message>
    <message>
        <source>Middle, Shift+left</source>
        <translation>中ボタン、Shift+左</translation>
    </message>
    <message>
        <source>shifts the map</source>
        <translation>地図を移動</translation>
    </message>
    <message>
        <source>Wheel, right button</source>
        <translation>ホイール、右ボタン</translation>
    </message>
    <message>
        <source>zooms</source>
        <translation>ズーム</translation>
    </message>
    <message>
        <source>Arrows, +, −</source>
        <translation>矢印、+、−</translation>
    </message>
    <message>
        <source>turn and zoom; with Shift they shift</source>
        <translation>回転とズーム。Shift で移動</translation>
    </message>
    <message>
        <source>Esc</source>
        <translation>Esc</translation>
    </message>
    <message>
        <source>ends measuring</source>
        <translation>計測を終了</translation>
    </message>
    <message>
        <source>Space</source>
        <translation>Space</translation>
    </message>
    <message>
        <source>in the scans list: shows or hides the scan</source>
        <translation>スキャン一覧: スキャンの表示/非表示</translation>
    </message>
    <message>
        <source>Tab, Shift+Tab</source>
        <translation>Tab、Shift+Tab</translation>
    </message>
    <message>
        <source>next and previous field</source>
        <translation>次/前の項目へ</translation>
    </message>
    <message>
        <source>&amp;Keys</source>
        <translation>キー一覧(&amp;K)</translation>
    </message>
    <message>
        <source>Lists all keys</source>
        <translation>すべてのキーを表示</translation>
    </message>
    <message>
        <source>&amp;About Leitstand</source>
        <translation>Leitstand について(&amp;A)</translation>
    </message>
    <message>
        <source>Keys</source>
        <translation>キー</translation>
    </message>
    <message>
        <source>Commands</source>
        <translation>コマンド</translation>
    </message>
    <message>
        <source>Map and lists</source>
        <translation>地図と一覧</translation>
    </message>
    <message>
        <source>About Leitstand</source>
        <translation>Leitstand について</translation>
    </message>
    <message>
        <source>Leitstand %1</source>
        <translation>Leitstand %1</translation>
    </message>
    <message>
        <source>The operator station for rescue robots: registers 3D laser scans into one map and shows it, after the methods of the RoboCup Rescue team Deutschland1.

Apache License 2.0</source>
        <translation>救助ロボット用の操作卓: 3D レーザースキャンを 1 つの地図に位置合わせして表示する。RoboCup Rescue チーム Deutschland1 の手法に基づく。

Apache License 2.0</translation>
    </message>
</context>
<context>
    <name>leitstand::JointDrawing</name>
    <message>
        <source>Flippers and arm, from the right</source>
        <translation>フリッパーとアーム（右から）</translation>
    </message>
</context>
<context>
    <name>leitstand::JointRowsModel</name>
    <message>
        <source>Joints</source>
        <translation>関節</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>位置</translation>
    </message>
</context>
<context>
    <name>leitstand::JointTexts</name>
    <message>
        <source>%1 m</source>
        <translation>%1 m</translation>
    </message>
    <message>
        <source>%1°</source>
        <translation>%1°</translation>
    </message>
    <message>
        <source> (%1 to %2)</source>
        <translation>（%1～%2）</translation>
    </message>
    <message>
        <source>%1: blocked, given up</source>
        <translation>%1：動かないため中止</translation>
    </message>
    <message>
        <source>%1: the robot does not tell where they are</source>
        <translation>%1：ロボットが位置を報告していません</translation>
    </message>
    <message>
        <source>%1: to %2</source>
        <translation>%1：%2へ</translation>
    </message>
    <message>
        <source>%1: no drive control</source>
        <translation>%1：操縦権なし</translation>
    </message>
</context>
<context>
    <name>leitstand::JointsFeature</name>
    <message>
        <source>Joints move only with drive control of a robot that is not stopped</source>
        <translation>関節は、停止していないロボットの操縦権があるときだけ動きます</translation>
    </message>
    <message>
        <source>&amp;Next flippers or joint</source>
        <translation>次のフリッパーまたは関節(&amp;N)</translation>
    </message>
    <message>
        <source>J raises what is chosen while it is held, K lowers it</source>
        <translation>Jを押している間、選択中のものを上げ、Kで下げます</translation>
    </message>
    <message>
        <source>Gamepad moves &amp;joints</source>
        <translation>ゲームパッドで関節を動かす(&amp;J)</translation>
    </message>
    <message>
        <source>With the trigger held, the stick that turns cameras raises and lowers what is chosen instead</source>
        <translation>トリガーを押している間、カメラのスティックが代わりに選択中のものを上げ下げします</translation>
    </message>
    <message>
        <source>Joints to preset %1</source>
        <translation>関節をプリセット%1へ</translation>
    </message>
    <message>
        <source>Moves all joints of the chosen group to a pose of the robot&apos;s file; Space or STOP ends it</source>
        <translation>選択中のグループの全関節をロボットのファイルの姿勢へ動かします。スペースまたはSTOPで終わります</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>次へ</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <comment>flippers: a preset</comment>
        <translation>%1：%2</translation>
    </message>
</context>
<context>
    <name>leitstand::JointsPanel</name>
    <message>
        <source>Flippers and arm</source>
        <translation>フリッパーとアーム</translation>
    </message>
    <message>
        <source>What the controls of joints move</source>
        <translation>関節の操作で動くもの</translation>
    </message>
    <message>
        <source>The file of %1 names no flippers and no arm</source>
        <translation>%1のファイルにはフリッパーもアームもありません</translation>
    </message>
</context>
<context>
    <name>leitstand::KeyColumns</name>
    <message>
        <source>Left button</source>
        <translation>左ボタン</translation>
    </message>
    <message>
        <source>turns the map; while measuring, picks a point</source>
        <translation>地図を回す。計測中は点を選ぶ</translation>
    </message>
    <message>
        <source>Middle, Shift+left</source>
        <translation>中ボタン、Shift+左</translation>
    </message>
    <message>
        <source>shifts the map</source>
        <translation>地図をずらす</translation>
    </message>
    <message>
        <source>Wheel, right button</source>
        <translation>ホイール、右ボタン</translation>
    </message>
    <message>
        <source>zooms the map</source>
        <translation>地図をズーム</translation>
    </message>
    <message>
        <source>Arrows, +, −</source>
        <translation>矢印、+、−</translation>
    </message>
    <message>
        <source>in the map that has the keyboard: turn and zoom; with Shift they shift</source>
        <translation>キーボードが地図にあるとき: 回転とズーム。Shift で移動</translation>
    </message>
    <message>
        <source>+, −</source>
        <translation>+, −</translation>
    </message>
    <message>
        <source>zoom the virtual scan that has the keyboard</source>
        <translation>キーボードが仮想スキャンにあるとき: ズーム</translation>
    </message>
    <message>
        <source>Ctrl+C</source>
        <translation>Ctrl+C</translation>
    </message>
    <message>
        <source>copies the chosen message</source>
        <translation>選んだメッセージをコピー</translation>
    </message>
    <message>
        <source>Tab, Shift+Tab</source>
        <translation>Tab、Shift+Tab</translation>
    </message>
    <message>
        <source>next and previous field</source>
        <translation>次と前の欄</translation>
    </message>
    <message>
        <source>Esc</source>
        <translation>Esc</translation>
    </message>
    <message>
        <source>stops all robots, always and everywhere</source>
        <translation>いつでもどこでも全ロボットを停止</translation>
    </message>
    <message>
        <source>Space or Return, held</source>
        <translation>スペースまたは Return を押し続ける</translation>
    </message>
    <message>
        <source>on the handle beside STOP: releases the robot</source>
        <translation>停止の横のハンドルで: ロボットを解放</translation>
    </message>
    <message>
        <source>Click into the camera</source>
        <translation>カメラ画像をクリック</translation>
    </message>
    <message>
        <source>drives with keys, as F2</source>
        <translation>F2 と同じくキーで運転</translation>
    </message>
    <message>
        <source>W S A D, arrows</source>
        <translation>W S A D、矢印</translation>
    </message>
    <message>
        <source>drive, while driving with keys; a robot&apos;s file may bind others</source>
        <translation>キー運転中に走る。ロボットのファイルで変更可</translation>
    </message>
    <message>
        <source>Shift, Ctrl</source>
        <translation>Shift、Ctrl</translation>
    </message>
    <message>
        <source>while driving: a quarter of the robot&apos;s speed, all of it</source>
        <translation>運転中: ロボットの速度の四分の一、全速</translation>
    </message>
    <message>
        <source>Space</source>
        <translation>スペース</translation>
    </message>
    <message>
        <source>while driving: halts the robot</source>
        <translation>運転中: ロボットを止める</translation>
    </message>
    <message>
        <source>G, held</source>
        <translation>G を押し続ける</translation>
    </message>
    <message>
        <source>while driving: drives without eyes</source>
        <translation>運転中: 視界なしで走る</translation>
    </message>
    <message>
        <source>Q E, Page Up, Page Down</source>
        <translation>Q E、Page Up、Page Down</translation>
    </message>
    <message>
        <source>turn the large camera while they are held, with Shift slowly</source>
        <translation>押している間、大きいカメラを回す。Shift でゆっくり</translation>
    </message>
    <message>
        <source>Number pad 4 6 8 2, 5</source>
        <translation>テンキー 4 6 8 2、5</translation>
    </message>
    <message>
        <source>turn the large camera; all cameras look ahead</source>
        <translation>大きいカメラを回す。全カメラを正面へ</translation>
    </message>
    <message>
        <source>Dragging the large picture</source>
        <translation>大きい画像をドラッグ</translation>
    </message>
    <message>
        <source>turns its camera</source>
        <translation>そのカメラを回す</translation>
    </message>
    <message>
        <source>Shift+click</source>
        <translation>Shift+クリック</translation>
    </message>
    <message>
        <source>into a picture or the virtual scan: files the victim that is there</source>
        <translation>画像か仮想スキャンで: そこの被災者を登録</translation>
    </message>
    <message>
        <source>Double click on the floor</source>
        <translation>床をダブルクリック</translation>
    </message>
    <message>
        <source>sends the selected robot there, if it takes goals</source>
        <translation>目標を受けるなら、選んだロボットをそこへ送る</translation>
    </message>
    <message>
        <source>Right button</source>
        <translation>右ボタン</translation>
    </message>
    <message>
        <source>while something is placed on the map: ends that, takes a corner back</source>
        <translation>地図に置いている間: やめる、角を一つ戻す</translation>
    </message>
    <message>
        <source>Return</source>
        <translation>Return</translation>
    </message>
    <message>
        <source>in a list: acknowledges the alarm, fills in the find&apos;s form, shows what was missed</source>
        <translation>一覧で: 警報を確認、発見物の記入、見落としを表示</translation>
    </message>
    <message>
        <source>Besides the commands</source>
        <translation>コマンドのほかに</translation>
    </message>
    <message>
        <source>← →</source>
        <translation>← →</translation>
    </message>
    <message>
        <source>in the timeline: a second back, on; with Shift ten</source>
        <translation>タイムラインで: 一秒戻る、進む。Shift で十秒</translation>
    </message>
    <message>
        <source>Home, End</source>
        <translation>Home、End</translation>
    </message>
    <message>
        <source>in the timeline: to the start, to the end</source>
        <translation>タイムラインで: 始めへ、終わりへ</translation>
    </message>
    <message>
        <source>in the list of finds: goes to when the chosen one was found</source>
        <translation>発見物の一覧で: 選んだものが見つかった時へ</translation>
    </message>
    <message>
        <source>ends measuring</source>
        <translation>計測を終える</translation>
    </message>
</context>
<context>
    <name>leitstand::KeyScanModel</name>
    <message>
        <source>Scan</source>
        <translation>スキャン</translation>
    </message>
    <message>
        <source>Counts</source>
        <translation>採否</translation>
    </message>
    <message>
        <source>Doubts</source>
        <translation>疑問点</translation>
    </message>
    <message>
        <source>Overlap</source>
        <translation>重なり</translation>
    </message>
    <message>
        <source>Entered</source>
        <translation>追加時刻</translation>
    </message>
    <message>
        <source>Set aside by the operator: neither shown nor used.</source>
        <translation>オペレータが除外: 表示も使用もしない。</translation>
    </message>
    <message>
        <source>It fits.</source>
        <translation>適合している。</translation>
    </message>
    <message>
        <source>Accepted by the operator.</source>
        <translation>オペレータが採用。</translation>
    </message>
    <message>
        <source>Overlap %1, pairs %2 mm apart, certainty %3, matched near scan %4</source>
        <translation>重なり %1、点対の距離 %2 mm、確実度 %3、スキャン %4 付近で照合</translation>
    </message>
    <message>
        <source>1 key scan</source>
        <translation>キースキャン 1 件</translation>
    </message>
    <message>
        <source>%1 key scans</source>
        <translation>キースキャン %1 件</translation>
    </message>
    <message>
        <source>%1 for you to decide</source>
        <translation>判断待ち %1 件</translation>
    </message>
</context>
<context>
    <name>leitstand::Language</name>
    <message>
        <source>The window is made again in this language</source>
        <translation>ウィンドウをこの言語で作り直す</translation>
    </message>
</context>
<context>
    <name>leitstand::LayoutFeature</name>
    <message>
        <source>S&amp;wap camera and map</source>
        <translation>カメラと地図を入れ替え(&amp;W)</translation>
    </message>
    <message>
        <source>Camera and map change places</source>
        <translation>カメラと地図の場所を交換</translation>
    </message>
    <message>
        <source>&amp;Arrange panes</source>
        <translation>ペインを配置(&amp;A)</translation>
    </message>
    <message>
        <source>Panes get titles to be dragged by, to another place or out of the window; again to hold them there</source>
        <translation>ペインにタイトルを表示。ドラッグで移動、ウィンドウの外へも出せる。再度選ぶと固定</translation>
    </message>
    <message>
        <source>Save la&amp;yout as…</source>
        <translation>レイアウトを別名で保存(&amp;Y)…</translation>
    </message>
    <message>
        <source>Keeps how panes are now as a layout of one&apos;s own</source>
        <translation>現在のペイン配置を独自のレイアウトとして保存</translation>
    </message>
    <message>
        <source>&amp;Delete this layout</source>
        <translation>このレイアウトを削除(&amp;D)</translation>
    </message>
    <message>
        <source>Deletes the file of a layout of one&apos;s own</source>
        <translation>独自レイアウトのファイルを削除</translation>
    </message>
    <message>
        <source>&amp;Panes</source>
        <translation>ペイン(&amp;P)</translation>
    </message>
    <message>
        <source>Layout %1</source>
        <translation>レイアウト %1</translation>
    </message>
    <message>
        <source>layout %1 binds keys to what is no command: %2</source>
        <translation>レイアウト %1 が存在しないコマンドにキーを割り当てている: %2</translation>
    </message>
    <message>
        <source>Save layout</source>
        <translation>レイアウトを保存</translation>
    </message>
    <message>
        <source>Name of the layout</source>
        <translation>レイアウトの名前</translation>
    </message>
    <message>
        <source>Drive</source>
        <translation>操縦</translation>
    </message>
    <message>
        <source>Explore</source>
        <translation>探索</translation>
    </message>
    <message>
        <source>Map</source>
        <translation>地図</translation>
    </message>
    <message>
        <source>Review</source>
        <translation>検証</translation>
    </message>
    <message>
        <source>Link</source>
        <translation>通信</translation>
    </message>
    <message>
        <source>Report</source>
        <translation>報告</translation>
    </message>
    <message>
        <source>Compare</source>
        <translation>比較</translation>
    </message>
    <message>
        <source>layout %1 binds keys that are none, or that mean something else: %2</source>
        <translation>レイアウト %1 のキー割り当てのうち、存在しないキーまたは他で使われているキー: %2</translation>
    </message>
</context>
<context>
    <name>leitstand::LayoutSwitch</name>
    <message>
        <source>Layout</source>
        <translation>レイアウト</translation>
    </message>
    <message>
        <source>Layout %1</source>
        <translation>レイアウト %1</translation>
    </message>
    <message>
        <source>Layout %1; a click shows the others</source>
        <translation>レイアウト %1。クリックで他を表示</translation>
    </message>
</context>
<context>
    <name>leitstand::LinkFeature</name>
    <message>
        <source>&amp;Thin link</source>
        <translation>低帯域(&amp;T)</translation>
    </message>
    <message>
        <source>Asks robots for less, so that what matters comes: commands and stop, telemetry, scans, one camera, the rest</source>
        <translation>ロボットへの要求を減らし、重要なデータを優先: 指令と停止、テレメトリ、スキャン、カメラ 1 台、その他</translation>
    </message>
    <message>
        <source>THIN LINK (T)</source>
        <translation>低帯域 (T)</translation>
    </message>
    <message>
        <source>Robots are asked for less: other cameras come rarely or not at all</source>
        <translation>ロボットへの要求を削減: 他のカメラはまれにしか届かないか、届かない</translation>
    </message>
    <message>
        <source>Thin link: telemetry, scans and one camera come first (T ends it)</source>
        <translation>低帯域: テレメトリ、スキャン、カメラ 1 台を優先（T で終了）</translation>
    </message>
    <message>
        <source>The link is not thin any more: everything as robots like</source>
        <translation>低帯域を終了: 送信はすべてロボット任せ</translation>
    </message>
</context>
<context>
    <name>leitstand::LinkPane</name>
    <message>
        <source>Sent</source>
        <translation>送信</translation>
    </message>
    <message>
        <source>Whether the robot sends this stream at all</source>
        <translation>ロボットがこのストリームを送信するかどうか</translation>
    </message>
    <message>
        <source>free</source>
        <translation>任意</translation>
    </message>
    <message>
        <source>Hz</source>
        <translation>Hz</translation>
    </message>
    <message>
        <source>Samples a second, at most; 0: as the robot likes</source>
        <translation>毎秒のサンプル数の上限。0: ロボット任せ</translation>
    </message>
    <message>
        <source>Quality</source>
        <translation>画質</translation>
    </message>
    <message>
        <source>Of JPEG pictures, 1 to 100; 0: as the robot likes</source>
        <translation>JPEG 画像の画質、1～100。0: ロボット任せ</translation>
    </message>
    <message>
        <source>Width px</source>
        <translation>幅 px</translation>
    </message>
    <message>
        <source>Wider pictures are made smaller; 0: as the robot likes</source>
        <translation>これより広い映像は縮小。0: ロボット任せ</translation>
    </message>
    <message>
        <source>What all streams of all robots take of the link</source>
        <translation>全ロボットの全ストリームが使う通信量</translation>
    </message>
    <message>
        <source>Mbit/s</source>
        <translation>Mbit/s</translation>
    </message>
    <message>
        <source>What a thin link has room for, all robots together</source>
        <translation>低帯域時の容量（全ロボット合計）</translation>
    </message>
    <message>
        <source>Link %1</source>
        <translation>通信 %1</translation>
    </message>
    <message>
        <source>Choose a stream</source>
        <translation>ストリームを選択</translation>
    </message>
    <message>
        <source>%1: not settable</source>
        <translation>%1: 設定不可</translation>
    </message>
    <message>
        <source>Makes the map</source>
        <translation>地図を作る</translation>
    </message>
    <message>
        <source>Whether the map is made from this cloud; the robot&apos;s others are shown, and used for obstacles</source>
        <translation>この点群から地図を作るかどうか。ロボットの他の点群は表示され、障害物に使われます</translation>
    </message>
</context>
<context>
    <name>leitstand::LinkStatus</name>
    <message>
        <source>3D scans</source>
        <translation>3D スキャン</translation>
    </message>
    <message>
        <source>laser</source>
        <translation>レーザー</translation>
    </message>
    <message>
        <source>odometry</source>
        <translation>オドメトリ</translation>
    </message>
    <message>
        <source>attitude</source>
        <translation>姿勢</translation>
    </message>
    <message>
        <source>joints</source>
        <translation>関節</translation>
    </message>
    <message>
        <source>transforms</source>
        <translation>座標変換</translation>
    </message>
    <message>
        <source>pictures</source>
        <translation>映像</translation>
    </message>
    <message>
        <source>camera data</source>
        <translation>カメラ情報</translation>
    </message>
    <message>
        <source>infrared</source>
        <translation>赤外線</translation>
    </message>
    <message>
        <source>gas</source>
        <translation>ガス</translation>
    </message>
    <message>
        <source>battery</source>
        <translation>バッテリー</translation>
    </message>
    <message>
        <source>diagnostics</source>
        <translation>診断</translation>
    </message>
    <message>
        <source>mode</source>
        <translation>モード</translation>
    </message>
    <message>
        <source>not heard yet</source>
        <translation>未受信</translation>
    </message>
    <message>
        <source>connected</source>
        <translation>接続中</translation>
    </message>
    <message>
        <source>degraded</source>
        <translation>通信低下</translation>
    </message>
    <message>
        <source>lost</source>
        <translation>途絶</translation>
    </message>
    <message>
        <source>silent for %1</source>
        <translation>%1 応答なし</translation>
    </message>
    <message>
        <source>%1 %2 old</source>
        <translation>%1 %2 前</translation>
    </message>
    <message>
        <source>%1 %2 late</source>
        <translation>%1 %2 遅延</translation>
    </message>
    <message>
        <source>%1 of %2 lost</source>
        <translation>%2 の %1 欠落</translation>
    </message>
    <message>
        <source>slow: %1</source>
        <translation>低速: %1</translation>
    </message>
    <message>
        <source>no answer for %1</source>
        <translation>%1 返答なし</translation>
    </message>
    <message>
        <source>%1 loss</source>
        <translation>欠落 %1</translation>
    </message>
    <message>
        <source>contacts</source>
        <translation>接触</translation>
    </message>
    <message>
        <source>sightings</source>
        <translation>発見報告</translation>
    </message>
    <message>
        <source>STOP</source>
        <translation>STOP</translation>
    </message>
    <message>
        <source>left</source>
        <comment>a camera</comment>
        <translation>左</translation>
    </message>
    <message>
        <source>right</source>
        <comment>a camera</comment>
        <translation>右</translation>
    </message>
    <message>
        <source>panorama</source>
        <comment>a camera</comment>
        <translation>パノラマ</translation>
    </message>
    <message>
        <source>infrared</source>
        <comment>a camera</comment>
        <translation>赤外線</translation>
    </message>
    <message>
        <source>%1 %2</source>
        <comment>a camera and what it sends: left pictures</comment>
        <translation>%1%2</translation>
    </message>
    <message>
        <source>fixed transforms</source>
        <translation>固定の座標変換</translation>
    </message>
    <message>
        <source>its own map</source>
        <translation>自身の地図</translation>
    </message>
    <message>
        <source>changes of its map</source>
        <translation>自身の地図の変更</translation>
    </message>
    <message>
        <source>its planned path</source>
        <translation>計画経路</translation>
    </message>
    <message>
        <source>readings</source>
        <translation>測定値</translation>
    </message>
    <message>
        <source>what it draws</source>
        <translation>描画</translation>
    </message>
    <message>
        <source>its model</source>
        <translation>モデル</translation>
    </message>
    <message>
        <source>what it sees in pictures</source>
        <translation>画像内の検出</translation>
    </message>
</context>
<context>
    <name>leitstand::LinksOnMap</name>
    <message>
        <source>Where the map meets &amp;itself</source>
        <translation>地図が自身と出会う所(&amp;I)</translation>
    </message>
    <message>
        <source>Lines between scans that see the same place: solid where the map follows them, dashed where it was asked or they were taken back, dotted where somebody said no</source>
        <translation>同じ場所を見たスキャンを結ぶ線: 実線は地図が従うもの、破線は質問中または取り消されたもの、点線は違うと答えたもの</translation>
    </message>
</context>
<context>
    <name>leitstand::LiveSummary</name>
    <message>
        <source>last scan %1 s ago</source>
        <translation>最終スキャン %1 秒前</translation>
    </message>
    <message>
        <source>last scan %1 min ago</source>
        <translation>最終スキャン %1 分前</translation>
    </message>
    <message>
        <source>3D map</source>
        <translation>3D 地図</translation>
    </message>
    <message>
        <source>1 key scan</source>
        <translation>キースキャン 1 件</translation>
    </message>
    <message>
        <source>%1 key scans</source>
        <translation>キースキャン %1 件</translation>
    </message>
    <message>
        <source>%1 points</source>
        <translation>%1 点</translation>
    </message>
    <message>
        <source>follows %1</source>
        <translation>%1 を追従</translation>
    </message>
    <message>
        <source>overlap %1</source>
        <translation>重なり %1</translation>
    </message>
    <message>
        <source>made by %1</source>
        <translation>%1 が作成</translation>
    </message>
    <message>
        <source>The newest key scan: whether it is certain, and how much of it meets the map; and how long ago any scan was laid onto the map</source>
        <translation>最新のキースキャン:確実かどうか、地図とどれだけ重なるか。また、いずれかのスキャンが最後に地図に合わせられてからの時間</translation>
    </message>
</context>
<context>
    <name>leitstand::LiveWindow</name>
    <message>
        <source>Leitstand</source>
        <translation>Leitstand</translation>
    </message>
    <message>
        <source>%1 is not connected</source>
        <translation>%1 は未接続</translation>
    </message>
</context>
<context>
    <name>leitstand::LogSays</name>
    <message>
        <source>the disk is full in {} minutes at {} MB/s</source>
        <translation>ディスクはあと {} 分で満杯({} MB/s)</translation>
    </message>
    <message>
        <source>the disk lasts {} minutes again</source>
        <translation>ディスクは再びあと {} 分もつ</translation>
    </message>
    <message>
        <source>the disk lasts for days again</source>
        <translation>ディスクは再び数日もつ</translation>
    </message>
    <message>
        <source>the disk is full; {} MB wait in memory</source>
        <translation>ディスクが満杯、{} MB がメモリで待機</translation>
    </message>
    <message>
        <source>there is space on the disk again</source>
        <translation>ディスクに再び空きがある</translation>
    </message>
    <message>
        <source>the disk does not keep up: {} s behind, {} MB wait, {} pictures dropped</source>
        <translation>ディスクが追いつかない: {} s 遅れ、{} MB 待機、画像 {} 枚を破棄</translation>
    </message>
    <message>
        <source>the disk keeps up again; {} pictures were dropped</source>
        <translation>ディスクが再び追いついた、画像 {} 枚を破棄</translation>
    </message>
    <message>
        <source>{} events that are no pictures are lost</source>
        <translation>画像以外の {} 件を失った</translation>
    </message>
    <message>
        <source>no more events are lost; {} were</source>
        <translation>これ以上は失われない、{} 件を失った</translation>
    </message>
    <message>
        <source>is written again</source>
        <translation>再び書き込み中</translation>
    </message>
</context>
<context>
    <name>leitstand::LookBar</name>
    <message>
        <source>cm</source>
        <translation>cm</translation>
    </message>
    <message>
        <source>m</source>
        <translation>m</translation>
    </message>
    <message>
        <source>Edge of the voxels</source>
        <translation>ボクセルの辺長</translation>
    </message>
    <message>
        <source>Heights above the first scan&apos;s scanner, in its frame</source>
        <translation>最初のスキャンのスキャナを基準とする高さ（その座標系）</translation>
    </message>
    <message>
        <source>Heights from</source>
        <translation>高さ</translation>
    </message>
    <message>
        <source>to</source>
        <translation>～</translation>
    </message>
</context>
<context>
    <name>leitstand::LoopNotice</name>
    <message>
        <source>Keep</source>
        <translation>維持</translation>
    </message>
    <message>
        <source>The loop stays closed; the menu Map opens it later, too</source>
        <translation>ループは閉じたままです。後で「地図」メニューからも開けます</translation>
    </message>
    <message>
        <source>The map met itself and closed the loop: scans moved by up to %1 m.</source>
        <translation>地図が同じ場所に戻り、ループを閉じました: スキャンが最大 %1 m 動きました。</translation>
    </message>
</context>
<context>
    <name>leitstand::LoopsFeature</name>
    <message>
        <source>It is the same place: c&amp;lose the loop</source>
        <translation>同じ場所です。ループを閉じる(&amp;L)</translation>
    </message>
    <message>
        <source>It is &amp;another place</source>
        <translation>別の場所です(&amp;A)</translation>
    </message>
    <message>
        <source>Take back the cl&amp;osed loop</source>
        <translation>閉じたループを取り消す(&amp;O)</translation>
    </message>
    <message>
        <source>Same place</source>
        <translation>同じ場所</translation>
    </message>
    <message>
        <source>Another place</source>
        <translation>別の場所</translation>
    </message>
    <message>
        <source>Open loop</source>
        <translation>ループを開く</translation>
    </message>
    <message>
        <source>The scans that see it are put together, and all others follow</source>
        <translation>その場所が見えるスキャンを合わせ、他のスキャンもそれに従います</translation>
    </message>
    <message>
        <source>The map stays as it is, and is not asked about there again</source>
        <translation>地図はそのままで、そこについてはもう質問しません</translation>
    </message>
    <message>
        <source>The newest place where the map met itself comes apart again: scans go back to where they were, and it does not close there by itself</source>
        <translation>地図がつながった最新の場所をまた離します。スキャンは元の位置に戻り、そこでは自動では閉じません</translation>
    </message>
    <message>
        <source>No loop closed in the map</source>
        <translation>地図の中で閉じたループはありません</translation>
    </message>
    <message>
        <source>Nothing is asked about the map</source>
        <translation>地図についての質問はありません</translation>
    </message>
    <message>
        <source>Is this a place that was seen before? The map is %1 off here, more than expected.</source>
        <translation>ここは前に見た場所ですか。地図はここで %1 ずれており、予想より大きいです。</translation>
    </message>
    <message>
        <source>Violet: the map if it is. Scans moved: %1, by up to %2.</source>
        <translation>紫: 同じ場所だった場合の地図。動くスキャン: %1、最大 %2。</translation>
    </message>
    <message>
        <source>Finds moved: %1.</source>
        <translation>動く発見物: %1。</translation>
    </message>
    <message>
        <source>If it is, no scan moves.</source>
        <translation>同じ場所でも、動くスキャンはありません。</translation>
    </message>
    <message>
        <source>Links of other loops that speak against it: %1.</source>
        <translation>矛盾する他のループの結合: %1。</translation>
    </message>
    <message>
        <source>Did these two parts of the map see the same place?</source>
        <translation>地図のこの2つの部分は同じ場所を見ましたか？</translation>
    </message>
    <message>
        <source>Map of %1, not joined yet</source>
        <translation>%1の地図（未結合）</translation>
    </message>
    <message>
        <source>%1 and %2 more</source>
        <translation>%1 ほか %2 件</translation>
    </message>
</context>
<context>
    <name>leitstand::MainWindow</name>
    <message>
        <source>Leitstand</source>
        <translation>Leitstand</translation>
    </message>
    <message>
        <source>Scans</source>
        <translation>スキャン</translation>
    </message>
    <message>
        <source>Registration</source>
        <translation>位置合わせ</translation>
    </message>
    <message>
        <source>Messages</source>
        <translation>メッセージ</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>ファイル(&amp;F)</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>表示(&amp;V)</translation>
    </message>
    <message>
        <source>&amp;Registration</source>
        <translation>位置合わせ(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>ヘルプ(&amp;H)</translation>
    </message>
    <message>
        <source>Click two points of the map · Esc ends measuring</source>
        <translation>地図上の 2 点をクリック · Esc で計測を終了</translation>
    </message>
    <message>
        <source>Saved %1</source>
        <translation>%1 を保存</translation>
    </message>
    <message>
        <source>%1 scans are registered</source>
        <translation>スキャン %1 件を位置合わせ済み</translation>
    </message>
    <message>
        <source>no picture: after %1 s only %2, others are not</source>
        <translation>画像なし: %1 s 経過、完了は「%2」のみ、残りは未完了</translation>
    </message>
    <message>
        <source>no picture: %1, but they are not drawn after %2 s</source>
        <translation>画像なし: %1、ただし %2 s 経過しても描画されない</translation>
    </message>
    <message>
        <source>%1: the picture could not be written</source>
        <translation>%1: 画像を書き込めない</translation>
    </message>
    <message>
        <source>Shows or hides the messages (F4)</source>
        <translation>メッセージの表示/非表示 (F4)</translation>
    </message>
</context>
<context>
    <name>leitstand::MapFeature</name>
    <message>
        <source>no scan is registered and drawn</source>
        <translation>位置合わせ・描画されたスキャンなし</translation>
    </message>
</context>
<context>
    <name>leitstand::MapGrantFeature</name>
    <message>
        <source>Hand the map over</source>
        <translation>地図を引き渡す</translation>
    </message>
    <message>
        <source>Another station registers the scans from now on, and decides on them; this one goes on showing its map</source>
        <translation>これからは別のステーションがスキャンを位置合わせし、判断します。このステーションはその地図を表示し続けます</translation>
    </message>
    <message>
        <source>Hand the map over to %1</source>
        <translation>地図を %1 に引き渡す</translation>
    </message>
    <message>
        <source>%1 makes the map: it is shown here, and decided on there</source>
        <translation>%1 が地図を作成しています:ここでは表示だけで、判断はそちらで行います</translation>
    </message>
    <message>
        <source>The map is made here</source>
        <translation>地図はここで作成しています</translation>
    </message>
</context>
<context>
    <name>leitstand::MapPane</name>
    <message>
        <source>3D map</source>
        <translation>3D 地図</translation>
    </message>
    <message>
        <source>Drop scans, a folder of scans or a mission here,
or choose File ▸ Open scans (Ctrl+O) or Open folder (Ctrl+Shift+O)

F1 lists all keys</source>
        <translation>ここにスキャン、スキャンのフォルダ、ミッションをドロップ、
またはファイル ▸ スキャンを開く (Ctrl+O)、フォルダを開く (Ctrl+Shift+O)

F1 でキー一覧</translation>
    </message>
</context>
<context>
    <name>leitstand::MapReadout</name>
    <message>
        <source>floor</source>
        <translation>床</translation>
    </message>
    <message>
        <source>wall</source>
        <translation>壁</translation>
    </message>
    <message>
        <source>ceiling</source>
        <translation>天井</translation>
    </message>
    <message>
        <source>unlabelled</source>
        <translation>ラベルなし</translation>
    </message>
    <message>
        <source>x %1  y %2  z %3 m · %4 · %5</source>
        <translation>x %1  y %2  z %3 m · %4 · %5</translation>
    </message>
    <message>
        <source>%1 m · dx %2 m  dy %3 m  dz %4 m</source>
        <translation>%1 m · dx %2 m  dy %3 m  dz %4 m</translation>
    </message>
</context>
<context>
    <name>leitstand::MapScenery</name>
    <message>
        <source>The map cannot be drawn: %1</source>
        <translation>地図を描画できない: %1</translation>
    </message>
</context>
<context>
    <name>leitstand::MapSummary</name>
    <message>
        <source>3D map</source>
        <translation>3D 地図</translation>
    </message>
    <message>
        <source>3D map · 1 scan · %1 points</source>
        <translation>3D 地図 · スキャン 1 件 · %1 点</translation>
    </message>
    <message>
        <source>3D map · %1 scans · %2 points</source>
        <translation>3D 地図 · スキャン %1 件 · %2 点</translation>
    </message>
    <message>
        <source>%1 %2</source>
        <translation>%1 %2</translation>
    </message>
    <message>
        <source>%1 scans %2</source>
        <translation>スキャン %1 件 %2</translation>
    </message>
    <message>
        <source>registered in %1 s · overlap %2 · %3</source>
        <translation>位置合わせ %1 s · 重なり %2 · %3</translation>
    </message>
    <message>
        <source>Time of all registrations, and the lowest overlap of all scans</source>
        <translation>全登録の所要時間と、全スキャン中の最小の重なり</translation>
    </message>
</context>
<context>
    <name>leitstand::MapView</name>
    <message>
        <source>3D map</source>
        <translation>3D 地図</translation>
    </message>
    <message>
        <source>floor</source>
        <translation>床</translation>
    </message>
    <message>
        <source>wall</source>
        <translation>壁</translation>
    </message>
    <message>
        <source>ceiling</source>
        <translation>天井</translation>
    </message>
    <message>
        <source>unlabelled</source>
        <translation>ラベルなし</translation>
    </message>
    <message>
        <source>uncertain ?</source>
        <translation>不確実 ?</translation>
    </message>
    <message>
        <source>height</source>
        <translation>高さ</translation>
    </message>
    <message>
        <source>range</source>
        <translation>距離</translation>
    </message>
    <message>
        <source>%1 m  dx %2 m dy %3 m dz %4 m</source>
        <comment>length of a measurement and its parts along the map&apos;s axes</comment>
        <translation>%1 m  dx %2 m dy %3 m dz %4 m</translation>
    </message>
    <message>
        <source>scan %1</source>
        <translation>スキャン %1</translation>
    </message>
    <message>
        <source>%1 m grid</source>
        <translation>グリッド %1 m</translation>
    </message>
    <message>
        <source>seen by camera</source>
        <translation>カメラで確認</translation>
    </message>
    <message>
        <source>missed by camera</source>
        <translation>カメラの見落とし</translation>
    </message>
    <message>
        <source>seen by infrared</source>
        <translation>赤外線で確認</translation>
    </message>
    <message>
        <source>missed by infrared</source>
        <translation>赤外線の見落とし</translation>
    </message>
    <message>
        <source>seen by scanner</source>
        <translation>スキャナで確認</translation>
    </message>
    <message>
        <source>missed by scanner</source>
        <translation>スキャナの見落とし</translation>
    </message>
    <message>
        <source>no robot named</source>
        <translation>ロボット名なし</translation>
    </message>
    <message>
        <source>no intensities in the data</source>
        <translation>反射強度の情報なし</translation>
    </message>
    <message>
        <source>intensity</source>
        <translation>反射強度</translation>
    </message>
    <message>
        <source>low</source>
        <translation>低</translation>
    </message>
    <message>
        <source>high</source>
        <translation>高</translation>
    </message>
    <message>
        <source>order</source>
        <translation>順序</translation>
    </message>
    <message>
        <source>first</source>
        <translation>最初</translation>
    </message>
    <message>
        <source>last</source>
        <translation>最後</translation>
    </message>
    <message>
        <source>age</source>
        <translation>経過時間</translation>
    </message>
    <message>
        <source>new</source>
        <translation>新</translation>
    </message>
    <message>
        <source>if it is one place</source>
        <comment>where scans would come to stand</comment>
        <translation>同じ場所の場合</translation>
    </message>
    <message>
        <source>new</source>
        <comment>what came to a place</comment>
        <translation>新規</translation>
    </message>
    <message>
        <source>gone</source>
        <comment>what was taken away</comment>
        <translation>消失</translation>
    </message>
    <message>
        <source>moved by hand</source>
        <translation>手で動かす部分</translation>
    </message>
    <message>
        <source>occupied</source>
        <translation>占有</translation>
    </message>
    <message>
        <source>free</source>
        <translation>空き</translation>
    </message>
</context>
<context>
    <name>leitstand::MeasuresDrawing</name>
    <message>
        <source>The robot from above and from its right side</source>
        <translation>ロボットの上面図と右側面図</translation>
    </message>
    <message>
        <source>%1 m long, %2 m wide, %3 m high</source>
        <translation>長さ %1 m、幅 %2 m、高さ %3 m</translation>
    </message>
    <message>
        <source>from above</source>
        <translation>上から</translation>
    </message>
    <message>
        <source>from the right</source>
        <translation>右から</translation>
    </message>
</context>
<context>
    <name>leitstand::MeasuresFeature</name>
    <message>
        <source>Si&amp;ze and sensors...</source>
        <translation>寸法とセンサー(&amp;Z)...</translation>
    </message>
    <message>
        <source>How large the selected robot is and where its sensors sit, with a drawing; from its model, or measured</source>
        <translation>選択中のロボットの寸法とセンサーの位置を図で示します。モデルから、または実測値で入力します</translation>
    </message>
    <message>
        <source>Size and sensors of %1</source>
        <translation>%1 の寸法とセンサー</translation>
    </message>
    <message>
        <source>A robot is being driven: the station would open again</source>
        <translation>ロボットを運転中です: ステーションが開き直されます</translation>
    </message>
</context>
<context>
    <name>leitstand::MeasuresForm</name>
    <message>
        <source>Sensors in the robot&apos;s base frame</source>
        <translation>ベース座標系でのセンサー</translation>
    </message>
    <message>
        <source>Where the robot tells a place by itself (tf_static), that one counts.</source>
        <translation>ロボット自身が位置を知らせる場合 (tf_static) は、そちらを使います。</translation>
    </message>
    <message>
        <source>Ahead</source>
        <translation>前方</translation>
    </message>
    <message>
        <source>Behind</source>
        <translation>後方</translation>
    </message>
    <message>
        <source>Left</source>
        <translation>左</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>右</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>高さ</translation>
    </message>
    <message>
        <source>From the base frame to the front end</source>
        <translation>ベース座標系から前端まで</translation>
    </message>
    <message>
        <source>From the base frame to the rear end</source>
        <translation>ベース座標系から後端まで</translation>
    </message>
    <message>
        <source>From the base frame to the left side</source>
        <translation>ベース座標系から左側面まで</translation>
    </message>
    <message>
        <source>From the base frame to the right side</source>
        <translation>ベース座標系から右側面まで</translation>
    </message>
    <message>
        <source>From the ground to the highest part</source>
        <translation>地面から最も高い部分まで</translation>
    </message>
    <message>
        <source>Take from its model</source>
        <translation>モデルから取得</translation>
    </message>
    <message>
        <source>Save and use</source>
        <translation>保存して使用</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>閉じる</translation>
    </message>
    <message>
        <source>Outline, height and sensor places as in the model that the robot publishes, all joints at rest</source>
        <translation>ロボットが発行するモデルの輪郭、高さ、センサー位置 (全関節は静止状態)</translation>
    </message>
    <message>
        <source>The robot publishes no model (robot_description), or it was not read yet</source>
        <translation>ロボットがモデル (robot_description) を発行していないか、まだ読み込まれていません</translation>
    </message>
    <message>
        <source>Writes the robot&apos;s file; the station opens again with it and goes on with its mission</source>
        <translation>ロボットのファイルを書き込みます。ステーションはそれを使って開き直し、任務を続けます</translation>
    </message>
    <message>
        <source>x</source>
        <translation>x</translation>
    </message>
    <message>
        <source>y</source>
        <translation>y</translation>
    </message>
    <message>
        <source>z</source>
        <translation>z</translation>
    </message>
    <message>
        <source>roll</source>
        <translation>ロール</translation>
    </message>
    <message>
        <source>pitch</source>
        <translation>ピッチ</translation>
    </message>
    <message>
        <source>yaw</source>
        <translation>ヨー</translation>
    </message>
    <message>
        <source>Frame %1</source>
        <translation>座標系 %1</translation>
    </message>
    <message>
        <source>The outline has %1 corners; a number that is changed here makes it a rectangle.</source>
        <translation>輪郭の角は %1 個です。ここで数値を変えると長方形になります。</translation>
    </message>
</context>
<context>
    <name>leitstand::MenuCorner</name>
    <message>
        <source>Newest message</source>
        <translation>最新メッセージ</translation>
    </message>
</context>
<context>
    <name>leitstand::MergeWords</name>
    <message>
        <source>There is no other find of this kind to merge it with</source>
        <translation>統合できる同種の発見がほかにない</translation>
    </message>
    <message>
        <source>%1, the nearest to %2, is %3 m away from it: move one of them there first</source>
        <translation>%2 に最も近い %1 は %3 m 離れています。先にどちらかを移動してください</translation>
    </message>
    <message>
        <source>%1 is part of %2 now, %3 m away</source>
        <translation>%1 は %3 m 離れた %2 に統合されました</translation>
    </message>
</context>
<context>
    <name>leitstand::MessageListModel</name>
    <message>
        <source>▲ Error  %1  %2</source>
        <translation>▲ エラー  %1  %2</translation>
    </message>
    <message>
        <source>Note  %1  %2</source>
        <translation>通知  %1  %2</translation>
    </message>
</context>
<context>
    <name>leitstand::MessagesFeature</name>
    <message>
        <source>Me&amp;ssages</source>
        <translation>メッセージ(&amp;S)</translation>
    </message>
    <message>
        <source>All messages so far, the newest last</source>
        <translation>これまでの通知(新しいものが最後)</translation>
    </message>
</context>
<context>
    <name>leitstand::MessagesPanel</name>
    <message>
        <source>Messages</source>
        <translation>メッセージ</translation>
    </message>
    <message>
        <source>Dismiss</source>
        <translation>消去</translation>
    </message>
    <message>
        <source>Takes the chosen message away (Del)</source>
        <translation>選択したメッセージを消去 (Del)</translation>
    </message>
    <message>
        <source>Dismiss all</source>
        <translation>すべて消去</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>コピー</translation>
    </message>
    <message>
        <source>Takes the chosen message away</source>
        <translation>選んだメッセージを消します</translation>
    </message>
</context>
<context>
    <name>leitstand::MissedModel</name>
    <message>
        <source>%1 m²</source>
        <translation>%1 m²</translation>
    </message>
    <message>
        <source>x %1, y %2</source>
        <translation>x %1、y %2</translation>
    </message>
    <message>
        <source>No floor is known yet</source>
        <translation>床はまだ不明</translation>
    </message>
    <message>
        <source>No.</source>
        <translation>番号</translation>
    </message>
    <message>
        <source>Missed</source>
        <translation>見落とし</translation>
    </message>
    <message>
        <source>Where</source>
        <translation>方向</translation>
    </message>
    <message>
        <source>In the map</source>
        <translation>地図上</translation>
    </message>
    <message>
        <source>%1: %2 of %3 m² seen, places missed: %4</source>
        <translation>%1: %3 m² 中 %2 確認、見落とし %4 か所</translation>
    </message>
    <message>
        <source>What was searched is not known yet</source>
        <translation>探索済みの範囲はまだ不明</translation>
    </message>
    <message>
        <source>Only small pieces were missed</source>
        <translation>見落としは小さな部分のみ</translation>
    </message>
    <message>
        <source>Nothing that can be reached was missed</source>
        <translation>到達可能な見落としなし</translation>
    </message>
    <message>
        <source>x %1, y %2, storey %3</source>
        <translation>x %1、y %2、%3階</translation>
    </message>
    <message>
        <source>; storey %1: %2</source>
        <translation>、%1階: %2</translation>
    </message>
</context>
<context>
    <name>leitstand::MissedPanel</name>
    <message>
        <source>What was missed</source>
        <translation>見落とし一覧</translation>
    </message>
    <message>
        <source>Searched with</source>
        <translation>探索センサー</translation>
    </message>
    <message>
        <source>With which sensor the floor counts as searched</source>
        <translation>どのセンサーで探索済みとみなすか</translation>
    </message>
    <message>
        <source>Floor that was missed, the largest piece first</source>
        <translation>見落とした床、大きい順</translation>
    </message>
</context>
<context>
    <name>leitstand::MissionFeature</name>
    <message>
        <source>&amp;Clock runs</source>
        <translation>時計を動かす(&amp;C)</translation>
    </message>
    <message>
        <source>Lets the mission&apos;s clock go, or holds it</source>
        <translation>ミッション時計を進める、または止める</translation>
    </message>
    <message>
        <source>&amp;Length of the mission…</source>
        <translation>ミッションの長さ(&amp;L)…</translation>
    </message>
    <message>
        <source>How long the mission may last: the clock counts down from it</source>
        <translation>ミッションの制限時間: 時計はここからカウントダウン</translation>
    </message>
    <message>
        <source>Clock to &amp;zero</source>
        <translation>時計をゼロに戻す(&amp;Z)</translation>
    </message>
    <message>
        <source>The mission begins now</source>
        <translation>ミッションを今から開始</translation>
    </message>
    <message>
        <source>Length of the mission</source>
        <translation>ミッションの長さ</translation>
    </message>
    <message>
        <source>Minutes; 0: without end</source>
        <translation>分。0: 制限なし</translation>
    </message>
    <message>
        <source>&amp;Go on with the mission before</source>
        <translation>前のミッションを続ける(&amp;G)</translation>
    </message>
    <message>
        <source>Ends this mission, and goes on with the one that was recorded until shortly before it: map, finds, clock</source>
        <translation>このミッションを終え、直前まで記録されていたミッションの地図・発見・時計を引き継ぐ</translation>
    </message>
    <message>
        <source>The mission before</source>
        <translation>前のミッション</translation>
    </message>
    <message>
        <source>End this mission and go on with %1?</source>
        <translation>このミッションを終えて %1 を続けますか?</translation>
    </message>
    <message>
        <source>Robots stop for some seconds. This mission is kept.</source>
        <translation>ロボットは数秒間停止します。このミッションは残ります。</translation>
    </message>
    <message>
        <source>Stay</source>
        <translation>このまま</translation>
    </message>
    <message>
        <source>Go on with it</source>
        <translation>続ける</translation>
    </message>
    <message>
        <source>A &amp;new mission in the map of…</source>
        <translation>地図を引き継ぐ新しいミッション(&amp;N)…</translation>
    </message>
    <message>
        <source>Ends this mission, and begins a new one that goes on in its map, or in that of an earlier one; robots find their place in it as they drive</source>
        <translation>このミッションを終了し、その地図または以前のミッションの地図を引き継ぐ新しいミッションを始めます。ロボットは走行しながら地図内の位置を見つけます</translation>
    </message>
    <message>
        <source>A new mission in the map of…</source>
        <translation>地図を引き継ぐ新しいミッション…</translation>
    </message>
    <message>
        <source>A new mission</source>
        <translation>新しいミッション</translation>
    </message>
    <message>
        <source>End this mission and begin a new one in the map of %1?</source>
        <translation>このミッションを終了し、%1の地図で新しいミッションを始めますか？</translation>
    </message>
    <message>
        <source>Begin it</source>
        <translation>始める</translation>
    </message>
</context>
<context>
    <name>leitstand::MissionForm</name>
    <message>
        <source>Mission data</source>
        <translation>ミッション情報</translation>
    </message>
    <message>
        <source>Competition</source>
        <translation>大会</translation>
    </message>
    <message>
        <source>RoboCup2026</source>
        <translation>RoboCup2026</translation>
    </message>
    <message>
        <source>Team</source>
        <translation>チーム</translation>
    </message>
    <message>
        <source>Country</source>
        <translation>国</translation>
    </message>
    <message>
        <source>Mission</source>
        <translation>ミッション</translation>
    </message>
    <message>
        <source>Preliminary1</source>
        <translation>予選1</translation>
    </message>
    <message>
        <source>Operators</source>
        <translation>オペレータ</translation>
    </message>
    <message>
        <source>People who drive; some rules divide the score by them</source>
        <translation>操縦する人数。規則によっては得点がこの数で割られる</translation>
    </message>
    <message>
        <source>Area</source>
        <translation>エリア</translation>
    </message>
    <message>
        <source>Of finds that say nothing else</source>
        <translation>他に指定のない発見物に使う</translation>
    </message>
    <message>
        <source>Rules of the score</source>
        <translation>採点規則</translation>
    </message>
    <message>
        <source>Names of the report&apos;s files begin with it</source>
        <translation>報告のファイル名はこれで始まります</translation>
    </message>
    <message>
        <source>As it was registered; in all lists of the report</source>
        <translation>登録したとおりの名前。報告のすべてのリストに入ります</translation>
    </message>
    <message>
        <source>Of the team; in all lists of the report</source>
        <translation>チームの国。報告のすべてのリストに入ります</translation>
    </message>
    <message>
        <source>Which run of the competition it is</source>
        <translation>競技会のどのランか</translation>
    </message>
    <message>
        <source>By these the score is estimated, here and in the report</source>
        <translation>これに従って、ここと報告で得点を見積もります</translation>
    </message>
</context>
<context>
    <name>leitstand::ModeCell</name>
    <message>
        <source>Keep</source>
        <translation>保持</translation>
    </message>
    <message>
        <source>Refuses: this station goes on driving</source>
        <translation>拒否: この操作卓が操縦を続ける</translation>
    </message>
    <message>
        <source>Mode of %1</source>
        <translation>%1 のモード</translation>
    </message>
    <message>
        <source>Request</source>
        <translation>要求</translation>
    </message>
    <message>
        <source>Requests drive control of this robot</source>
        <translation>このロボットの操縦権を要求</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取り下げ</translation>
    </message>
    <message>
        <source>Withdraws the request</source>
        <translation>要求を取り下げる</translation>
    </message>
    <message>
        <source>Release</source>
        <translation>返上</translation>
    </message>
    <message>
        <source>Releases drive control: others may take it</source>
        <translation>操縦権を返上: 他の操作卓が取得できる</translation>
    </message>
    <message>
        <source>Give</source>
        <translation>譲る</translation>
    </message>
    <message>
        <source>Consents: the other station drives</source>
        <translation>同意: 別の操作卓が操縦する</translation>
    </message>
    <message>
        <source>%1 mode</source>
        <translation>%1 のモード</translation>
    </message>
    <message>
        <source>speed</source>
        <translation>速度</translation>
    </message>
    <message>
        <source>turn</source>
        <translation>旋回</translation>
    </message>
    <message>
        <source>nearest</source>
        <translation>最近接</translation>
    </message>
</context>
<context>
    <name>leitstand::ModeLabel</name>
    <message>
        <source>TELEOPERATION</source>
        <translation>遠隔操作</translation>
    </message>
    <message>
        <source>MODE UNKNOWN</source>
        <translation>モード不明</translation>
    </message>
    <message>
        <source>the robot tells none</source>
        <translation>ロボットの通知なし</translation>
    </message>
    <message>
        <source>stopped</source>
        <translation>停止中</translation>
    </message>
    <message>
        <source>teleoperation</source>
        <translation>遠隔操作</translation>
    </message>
    <message>
        <source>safe teleoperation</source>
        <translation>安全遠隔操作</translation>
    </message>
    <message>
        <source>explore</source>
        <translation>自律探索</translation>
    </message>
    <message>
        <source>victim approach</source>
        <translation>被災者接近</translation>
    </message>
    <message>
        <source>radio remote</source>
        <translation>無線操縦</translation>
    </message>
    <message>
        <source>NOT HEARD YET</source>
        <translation>未受信</translation>
    </message>
    <message>
        <source>waits for the robot</source>
        <translation>ロボットを待機中</translation>
    </message>
    <message>
        <source>silent for %1 · was in %2</source>
        <translation>%1 応答なし · 直前は%2</translation>
    </message>
    <message>
        <source>silent for %1</source>
        <translation>%1 応答なし</translation>
    </message>
    <message>
        <source>LINK LOST</source>
        <translation>通信途絶</translation>
    </message>
    <message>
        <source>STOP</source>
        <translation>STOP</translation>
    </message>
    <message>
        <source>%1 · OVERRIDE</source>
        <translation>%1 · オーバーライド</translation>
    </message>
    <message>
        <source>teleop</source>
        <translation>遠隔</translation>
    </message>
    <message>
        <source>safe teleop</source>
        <translation>安全遠隔</translation>
    </message>
    <message>
        <source>approach</source>
        <translation>接近</translation>
    </message>
    <message>
        <source>remote</source>
        <translation>無線</translation>
    </message>
    <message>
        <source>NO MODES</source>
        <translation>モードなし</translation>
    </message>
    <message>
        <source>others may drive it, too</source>
        <translation>他からも操縦できます</translation>
    </message>
    <message>
        <source>TO ITS GOAL</source>
        <translation>目標へ移動中</translation>
    </message>
    <message>
        <source>GOAL</source>
        <translation>目標</translation>
    </message>
</context>
<context>
    <name>leitstand::MoreRobotsButton</name>
    <message>
        <source>Robots to the left</source>
        <translation>左側のロボット</translation>
    </message>
    <message>
        <source>Robots to the right</source>
        <translation>右側のロボット</translation>
    </message>
    <message>
        <source>Robots out of sight: %1</source>
        <translation>表示外のロボット: %1</translation>
    </message>
</context>
<context>
    <name>leitstand::PadCallouts</name>
    <message>
        <source>drive</source>
        <translation>走行</translation>
    </message>
    <message>
        <source>turn</source>
        <translation>旋回</translation>
    </message>
    <message>
        <source>sideways</source>
        <translation>横移動</translation>
    </message>
    <message>
        <source>cameras</source>
        <translation>カメラ</translation>
    </message>
    <message>
        <source>Left stick</source>
        <translation>左スティック</translation>
    </message>
    <message>
        <source>Right stick</source>
        <translation>右スティック</translation>
    </message>
</context>
<context>
    <name>leitstand::PadFeature</name>
    <message>
        <source>Select the &amp;next robot</source>
        <translation>次のロボットを選択(&amp;N)</translation>
    </message>
    <message>
        <source>Selects the next robot, after the last one the first</source>
        <translation>次のロボットを選択。最後の次は最初に戻る</translation>
    </message>
    <message>
        <source>&amp;Gamepad …</source>
        <translation>ゲームパッド(&amp;G) …</translation>
    </message>
    <message>
        <source>Which gamepad drives, and what its controls do</source>
        <translation>操縦に使うゲームパッドと各操作の割り当て</translation>
    </message>
    <message>
        <source>&amp;Controls of the gamepad</source>
        <translation>ゲームパッドの操作(&amp;C)</translation>
    </message>
    <message>
        <source>Shows what each control of the gamepad does</source>
        <translation>ゲームパッドの各操作の働きを表示</translation>
    </message>
    <message>
        <source>%1 is plugged in; H shows its controls.</source>
        <translation>%1 を接続。H で操作を表示。</translation>
    </message>
    <message>
        <source>%1 is unplugged.</source>
        <translation>%1 が外れた。</translation>
    </message>
    <message>
        <source>Let the sticks go first, and the trigger too if that is not enough.</source>
        <translation>まずスティックを放す。足りなければトリガーも放す。</translation>
    </message>
</context>
<context>
    <name>leitstand::PadInput</name>
    <message>
        <source>%1 has no known controls: give it some in the gamepad&apos;s dialog.</source>
        <translation>%1 の操作は未定義: ゲームパッドの設定で割り当てること。</translation>
    </message>
</context>
<context>
    <name>leitstand::PadLegend</name>
    <message>
        <source>Controls of the gamepad</source>
        <translation>ゲームパッドの操作</translation>
    </message>
    <message>
        <source>What the gamepad&apos;s controls do; a click closes this</source>
        <translation>ゲームパッドの操作の働き。クリックで閉じる</translation>
    </message>
    <message>
        <source>Gamepad: none is plugged in</source>
        <translation>ゲームパッド: 未接続</translation>
    </message>
    <message>
        <source>Gamepad: %1</source>
        <translation>ゲームパッド: %1</translation>
    </message>
    <message>
        <source>The trigger held and the window in front: the pad drives. STOP works always.</source>
        <translation>トリガーを押し、ウィンドウが前面にある間、パッドで操縦。STOP は常に有効。</translation>
    </message>
</context>
<context>
    <name>leitstand::PadMappingDialog</name>
    <message>
        <source>Gamepad</source>
        <translation>ゲームパッド</translation>
    </message>
    <message>
        <source>The gamepad that drives; STOP works on all</source>
        <translation>操縦に使うゲームパッド。STOP はすべてで有効</translation>
    </message>
    <message>
        <source>Gamepad that drives</source>
        <translation>操縦用ゲームパッド</translation>
    </message>
    <message>
        <source>What the gamepad does, and by which control</source>
        <translation>ゲームパッドの働きと、それを行う操作</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>&amp;Dead zone</source>
        <translation>不感帯(&amp;D)</translation>
    </message>
    <message>
        <source>Around the middle of a stick nothing moves</source>
        <translation>スティックの中央付近では何も動かない</translation>
    </message>
    <message>
        <source>&amp;Fine middle</source>
        <translation>中央の細かさ(&amp;F)</translation>
    </message>
    <message>
        <source>Sticks are finer around their middle</source>
        <translation>スティックは中央付近で細かく効く</translation>
    </message>
    <message>
        <source>&amp;Trigger at</source>
        <translation>トリガー点(&amp;T)</translation>
    </message>
    <message>
        <source>How far a trigger is pulled until it counts</source>
        <translation>トリガーが有効になる引き量</translation>
    </message>
    <message>
        <source>Forward ← → back</source>
        <translation>前進 ← → バック</translation>
    </message>
    <message>
        <source>Turn left ← → right</source>
        <translation>左旋回 ← → 右旋回</translation>
    </message>
    <message>
        <source>Camera left ← → right</source>
        <translation>カメラ 左 ← → 右</translation>
    </message>
    <message>
        <source>Camera up ← → down</source>
        <translation>カメラ 上 ← → 下</translation>
    </message>
    <message>
        <source>Se&amp;t …</source>
        <translation>割り当て(&amp;T) …</translation>
    </message>
    <message>
        <source>The next control that you push does what is selected</source>
        <translation>次に動かした操作を、選択した働きに割り当てる</translation>
    </message>
    <message>
        <source>&amp;Clear</source>
        <translation>解除(&amp;C)</translation>
    </message>
    <message>
        <source>No control does what is selected</source>
        <translation>選択した働きの割り当てを解除</translation>
    </message>
    <message>
        <source>&amp;Usual</source>
        <translation>標準(&amp;U)</translation>
    </message>
    <message>
        <source>What gamepads usually do here; not saved yet</source>
        <translation>ゲームパッドの標準の割り当てに戻す。まだ保存されない</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>保存(&amp;S)</translation>
    </message>
    <message>
        <source>Use this now, and whenever such a gamepad is plugged in</source>
        <translation>今から使用し、同じ種類のゲームパッドの接続時にも使う</translation>
    </message>
    <message>
        <source>No gamepad is plugged in</source>
        <translation>ゲームパッド未接続</translation>
    </message>
    <message>
        <source>Canc&amp;el</source>
        <translation>キャンセル(&amp;E)</translation>
    </message>
    <message>
        <source>Not saved yet.</source>
        <translation>未保存。</translation>
    </message>
    <message>
        <source>Push the control for “%1” now.</source>
        <translation>「%1」に使う操作を今動かす。</translation>
    </message>
</context>
<context>
    <name>leitstand::PadTable</name>
    <message>
        <source>“%1” needs a control.</source>
        <translation>「%1」には操作の割り当てが必要。</translation>
    </message>
    <message>
        <source>%1 stops all robots, and does nothing else.</source>
        <translation>%1 は全ロボットを停止し、他の働きはしない。</translation>
    </message>
    <message>
        <source>push it now …</source>
        <translation>今動かす …</translation>
    </message>
    <message>
        <source>does</source>
        <translation>働き</translation>
    </message>
    <message>
        <source>control</source>
        <translation>操作</translation>
    </message>
</context>
<context>
    <name>leitstand::PadTexts</name>
    <message>
        <source>Left stick left</source>
        <translation>左スティック 左</translation>
    </message>
    <message>
        <source>Left stick right</source>
        <translation>左スティック 右</translation>
    </message>
    <message>
        <source>Left stick up</source>
        <translation>左スティック 上</translation>
    </message>
    <message>
        <source>Left stick down</source>
        <translation>左スティック 下</translation>
    </message>
    <message>
        <source>Right stick left</source>
        <translation>右スティック 左</translation>
    </message>
    <message>
        <source>Right stick right</source>
        <translation>右スティック 右</translation>
    </message>
    <message>
        <source>Right stick up</source>
        <translation>右スティック 上</translation>
    </message>
    <message>
        <source>Right stick down</source>
        <translation>右スティック 下</translation>
    </message>
    <message>
        <source>Left trigger</source>
        <translation>左トリガー</translation>
    </message>
    <message>
        <source>Right trigger</source>
        <translation>右トリガー</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>バック</translation>
    </message>
    <message>
        <source>Guide</source>
        <translation>ガイド</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>スタート</translation>
    </message>
    <message>
        <source>Left stick pressed</source>
        <translation>左スティック押し込み</translation>
    </message>
    <message>
        <source>Right stick pressed</source>
        <translation>右スティック押し込み</translation>
    </message>
    <message>
        <source>Left shoulder</source>
        <translation>左ショルダー</translation>
    </message>
    <message>
        <source>Right shoulder</source>
        <translation>右ショルダー</translation>
    </message>
    <message>
        <source>Cross up</source>
        <translation>十字キー 上</translation>
    </message>
    <message>
        <source>Cross down</source>
        <translation>十字キー 下</translation>
    </message>
    <message>
        <source>Cross left</source>
        <translation>十字キー 左</translation>
    </message>
    <message>
        <source>Cross right</source>
        <translation>十字キー 右</translation>
    </message>
    <message>
        <source>Hold to drive</source>
        <translation>デッドマン（押して走行）</translation>
    </message>
    <message>
        <source>Forward</source>
        <translation>前進</translation>
    </message>
    <message>
        <source>Turn left</source>
        <translation>左旋回</translation>
    </message>
    <message>
        <source>Turn right</source>
        <translation>右旋回</translation>
    </message>
    <message>
        <source>Sideways left</source>
        <translation>左へ横移動</translation>
    </message>
    <message>
        <source>Sideways right</source>
        <translation>右へ横移動</translation>
    </message>
    <message>
        <source>Turbo</source>
        <translation>ターボ</translation>
    </message>
    <message>
        <source>Slow</source>
        <translation>低速</translation>
    </message>
    <message>
        <source>STOP all robots</source>
        <translation>全ロボット STOP</translation>
    </message>
    <message>
        <source>Camera left</source>
        <translation>カメラ 左</translation>
    </message>
    <message>
        <source>Camera right</source>
        <translation>カメラ 右</translation>
    </message>
    <message>
        <source>Camera up</source>
        <translation>カメラ 上</translation>
    </message>
    <message>
        <source>Camera down</source>
        <translation>カメラ 下</translation>
    </message>
    <message>
        <source>Hold: without eyes</source>
        <translation>押し続ける: 視界なし走行</translation>
    </message>
    <message>
        <source>The robot moves only while this is held; letting it go stops it at once</source>
        <translation>押している間だけロボットが動く。放すと直ちに停止</translation>
    </message>
    <message>
        <source>All of the robot&apos;s speed instead of 60 %</source>
        <translation>60 % ではなく、ロボットの最高速度</translation>
    </message>
    <message>
        <source>A quarter of the robot&apos;s speed</source>
        <translation>ロボットの最高速度の 4 分の 1</translation>
    </message>
    <message>
        <source>While it is held, old or missing pictures do not cap the speed</source>
        <translation>押している間、映像が古い・ない場合も速度を制限しない</translation>
    </message>
    <message>
        <source>Stops all robots, always: without the trigger, and whatever window has the focus</source>
        <translation>常に全ロボットを停止: トリガー不要、どのウィンドウにフォーカスがあっても有効</translation>
    </message>
    <message>
        <source>For robots that can drive sideways</source>
        <translation>横移動できるロボット用</translation>
    </message>
    <message>
        <source>Turns the cameras, also while the robot stands</source>
        <translation>カメラを旋回。ロボット停止中も有効</translation>
    </message>
    <message>
        <source>Drives the selected robot while the trigger is held</source>
        <translation>トリガーを押している間、選択中のロボットを走行</translation>
    </message>
    <message>
        <source>Button %1</source>
        <translation>ボタン %1</translation>
    </message>
    <message>
        <source>Axis %1 %2</source>
        <translation>軸 %1 %2</translation>
    </message>
    <message>
        <source>Nothing moves: no control is bound to “%1”.</source>
        <translation>何も動かない: 「%1」に操作が割り当てられていない。</translation>
    </message>
    <message>
        <source>Hold “%1” first, then push the stick; let it go and the robot stands.</source>
        <translation>まず「%1」を押し続け、次にスティックを倒す。放すとロボットは停止。</translation>
    </message>
    <message>
        <source>Plug one in, or pair it by Bluetooth, at any time: what SDL knows works at once (Xbox, DualShock, DualSense, Switch Pro, Steam; Logitech and 8BitDo in their X mode). Any other joystick is bound in the menu Robot, Gamepad: STOP first. This is what the controls would do:</source>
        <translation>いつでも接続、または Bluetooth でペアリングできます。SDL が知る機種はすぐ使えます（Xbox、DualShock、DualSense、Switch Pro、Steam、X モードの Logitech と 8BitDo）。その他のジョイスティックはメニュー「ロボット」の「ゲームパッド」で割り当てます（まず STOP）。各操作の働き：</translation>
    </message>
    <message>
        <source>Until then keys drive: F2, then W S A D or the arrows; Shift slow, Ctrl fast; Space halts; G held drives without eyes; Esc stops all robots, always.</source>
        <translation>それまではキーで操縦します：F2 の後 W S A D または矢印、Shift で低速、Ctrl で高速、Space で停止、G を押す間は視界なしで走行、Esc は常に全ロボットを停止。</translation>
    </message>
</context>
<context>
    <name>leitstand::PlaceRobot</name>
    <message>
        <source>P&amp;lace a robot</source>
        <translation>ロボットを配置(&amp;L)</translation>
    </message>
    <message>
        <source>Click on the map where a robot stands that is not in it yet, or the selected one; drag its heading</source>
        <translation>まだ地図にないロボット、または選択中のロボットの位置を地図上でクリック、ドラッグで向きを指定</translation>
    </message>
    <message>
        <source>Click where %1 stands, drag its heading · right button: not at all</source>
        <translation>%1 の位置をクリック、ドラッグで向きを指定 · 右ボタン: 中止</translation>
    </message>
    <message>
        <source>F&amp;ind the robot in the whole map</source>
        <translation>ロボットを地図全体から探す(&amp;I)</translation>
    </message>
    <message>
        <source>Looks by the newest 3D scan of the selected robot for where it stands, anywhere in the map: for one that was carried or is lost</source>
        <translation>選択中のロボットの最新の 3D スキャンで、地図のどこにいるかを探します。運ばれたときや見失ったときに</translation>
    </message>
</context>
<context>
    <name>leitstand::PreflightFeature</name>
    <message>
        <source>&amp;Preflight...</source>
        <translation>出動前点検(&amp;P)...</translation>
    </message>
    <message>
        <source>What is in order before the mission and what is not; brake tests; adding robots</source>
        <translation>ミッション前に問題のない点とある点、ブレーキ試験、ロボットの追加</translation>
    </message>
    <message>
        <source>Preflight</source>
        <translation>出動前点検</translation>
    </message>
    <message>
        <source>NO WATCHDOG: %1</source>
        <translation>ウォッチドッグなし: %1</translation>
    </message>
    <message>
        <source>Failed its brake test and is driven nevertheless: without radio it goes on. When this station hangs or dies, its guard stops it</source>
        <translation>ブレーキ試験に不合格のまま操縦中: 無線が切れても動き続ける。この操縦卓が固まるか落ちると、ガードが停止させる</translation>
    </message>
    <message>
        <source>BRAKES LATE: %1</source>
        <translation>制動遅れ: %1</translation>
    </message>
    <message>
        <source>Failed its brake test and is driven nevertheless: without radio it stands late</source>
        <translation>ブレーキ試験に不合格のまま操縦中: 無線が切れると停止が遅い</translation>
    </message>
    <message>
        <source>%1 is not heard any more</source>
        <translation>%1 からの受信が途絶えた</translation>
    </message>
    <message>
        <source>Robot file</source>
        <translation>ロボットファイル</translation>
    </message>
    <message>
        <source>Robot files (*.yaml *.yml)</source>
        <translation>ロボットファイル (*.yaml *.yml)</translation>
    </message>
</context>
<context>
    <name>leitstand::PreflightList</name>
    <message>
        <source>Station</source>
        <translation>操作卓</translation>
    </message>
    <message>
        <source>Of</source>
        <translation>対象</translation>
    </message>
    <message>
        <source>Check</source>
        <translation>点検</translation>
    </message>
    <message>
        <source>What to do</source>
        <translation>対応</translation>
    </message>
    <message>
        <source>%1 MB/s</source>
        <translation>%1 MB/s</translation>
    </message>
    <message>
        <source>stands after %1 and %2 cm</source>
        <translation>%1、%2 cm で停止</translation>
    </message>
    <message>
        <source>%1 min</source>
        <translation>%1 min</translation>
    </message>
    <message>
        <source>%1 h</source>
        <translation>%1 h</translation>
    </message>
    <message>
        <source>clock %1 behind ours</source>
        <translation>時計が操作卓より %1 遅れ</translation>
    </message>
    <message>
        <source>clock %1 ahead of ours</source>
        <translation>時計が操作卓より %1 進み</translation>
    </message>
    <message>
        <source>connected, but %1</source>
        <translation>接続中、ただし %1</translation>
    </message>
    <message>
        <source>connected, round trip %1</source>
        <translation>接続中、往復 %1</translation>
    </message>
    <message>
        <source>connected</source>
        <translation>接続中</translation>
    </message>
    <message>
        <source>silent for %1</source>
        <translation>%1 応答なし</translation>
    </message>
    <message>
        <source>not heard yet</source>
        <translation>未受信</translation>
    </message>
    <message>
        <source>%1 streams come</source>
        <translation>ストリーム %1 件を受信</translation>
    </message>
    <message>
        <source>never came: %1</source>
        <translation>一度も届いていない: %1</translation>
    </message>
    <message>
        <source>do not come any more: %1</source>
        <translation>届かなくなった: %1</translation>
    </message>
    <message>
        <source>camera pictures are fresh</source>
        <translation>カメラ映像は新しい</translation>
    </message>
    <message>
        <source>no fresh pictures: %1</source>
        <translation>新しい映像なし: %1</translation>
    </message>
    <message>
        <source>its clock is not known yet</source>
        <translation>時計は未確認</translation>
    </message>
    <message>
        <source>this station may drive it</source>
        <translation>この操作卓が操縦できる</translation>
    </message>
    <message>
        <source>drive control is free</source>
        <translation>操縦権の保持者なし</translation>
    </message>
    <message>
        <source>%1 has drive control</source>
        <translation>%1 が操縦権を保持</translation>
    </message>
    <message>
        <source>hears no drive commands</source>
        <translation>走行指令を受信していない</translation>
    </message>
    <message>
        <source>stopped</source>
        <translation>停止中</translation>
    </message>
    <message>
        <source>brake: %1 without commands</source>
        <translation>ブレーキ: 指令なしで %1</translation>
    </message>
    <message>
        <source>brake: tested more than a day ago, %1</source>
        <translation>ブレーキ: 試験から 1 日以上経過、%1</translation>
    </message>
    <message>
        <source>brake: not tested</source>
        <translation>ブレーキ: 未試験</translation>
    </message>
    <message>
        <source>brake: FAILED, %1; driving is refused</source>
        <translation>ブレーキ: 不合格、%1。操縦は拒否</translation>
    </message>
    <message>
        <source>brake: FAILED, and driven nevertheless</source>
        <translation>ブレーキ: 不合格、それでも操縦中</translation>
    </message>
    <message>
        <source>brake: FAILED, and driven nevertheless; %1</source>
        <translation>ブレーキ: 不合格、それでも操縦中。%1</translation>
    </message>
    <message>
        <source>brakes after %1, stands after %2 and %3 cm</source>
        <translation>%1 後に制動、%2・%3 cm で停止</translation>
    </message>
    <message>
        <source>still moves %1 after the last command</source>
        <translation>最後の指令の %1 後も動く</translation>
    </message>
    <message>
        <source>moves without commands</source>
        <translation>指令なしで動く</translation>
    </message>
    <message>
        <source>its guard is not heard by it yet</source>
        <translation>ガードの声がまだ届いていない</translation>
    </message>
    <message>
        <source>its guard stands by</source>
        <translation>ガード待機中</translation>
    </message>
    <message>
        <source>no guard: %1</source>
        <translation>ガードなし: %1</translation>
    </message>
    <message>
        <source>brake: no result (%1)</source>
        <translation>ブレーキ: 結果なし（%1）</translation>
    </message>
    <message>
        <source>not secured: anybody in the network may speak</source>
        <translation>保護なし: ネットワーク内の誰でも発信できる</translation>
    </message>
    <message>
        <source>robot &quot;%1&quot; is heard, and not driven</source>
        <translation>ロボット &quot;%1&quot; を受信、操縦対象外</translation>
    </message>
    <message>
        <source>network: %1</source>
        <translation>ネットワーク: %1</translation>
    </message>
    <message>
        <source>network: this computer only</source>
        <translation>ネットワーク: このコンピュータのみ</translation>
    </message>
    <message>
        <source>disk: room for %1, writes %2</source>
        <translation>ディスク: 記録余裕 %1、書き込み %2</translation>
    </message>
    <message>
        <source>disk: room for %1</source>
        <translation>ディスク: 記録余裕 %1</translation>
    </message>
    <message>
        <source>disk: writes only %1, the log needs %2</source>
        <translation>ディスク: 書き込み %1 のみ、ログには %2 必要</translation>
    </message>
    <message>
        <source>disk: room for %1 only</source>
        <translation>ディスク: 記録余裕 %1 のみ</translation>
    </message>
    <message>
        <source>nothing is recorded: %1</source>
        <translation>記録されていない: %1</translation>
    </message>
    <message>
        <source>gamepad: %1</source>
        <translation>ゲームパッド: %1</translation>
    </message>
    <message>
        <source>no gamepad: keys drive</source>
        <translation>ゲームパッドなし: キーで操縦</translation>
    </message>
    <message>
        <source>Add it below</source>
        <translation>下で追加する</translation>
    </message>
    <message>
        <source>Is it on, in this network, and in this domain?</source>
        <translation>電源、ネットワーク、ドメインを確認</translation>
    </message>
    <message>
        <source>Come nearer, or thin the link (T)</source>
        <translation>近づく、または低帯域にする (T)</translation>
    </message>
    <message>
        <source>Is the sensor on? Does the robot&apos;s file name its topic?</source>
        <translation>センサの電源を確認。ロボットファイルにトピックがあるか確認</translation>
    </message>
    <message>
        <source>Is the camera on? Its driver may hang</source>
        <translation>カメラの電源を確認。ドライバの停止の可能性あり</translation>
    </message>
    <message>
        <source>Change the QoS in the robot&apos;s file</source>
        <translation>ロボットファイルの QoS を変更</translation>
    </message>
    <message>
        <source>Wait a moment</source>
        <translation>しばらく待つ</translation>
    </message>
    <message>
        <source>Ask for it when you want to drive (F2)</source>
        <translation>操縦するときに要求する (F2)</translation>
    </message>
    <message>
        <source>Is its drive node running? Right topic and type?</source>
        <translation>走行ノードの動作、トピックと型を確認</translation>
    </message>
    <message>
        <source>Release it: hold its handle beside STOP</source>
        <translation>解除する: STOP 横のハンドルを押し続ける</translation>
    </message>
    <message>
        <source>Test it: hold the button below</source>
        <translation>試験する: 下のボタンを押し続ける</translation>
    </message>
    <message>
        <source>Give it a watchdog, test again, or drive it nevertheless</source>
        <translation>ウォッチドッグを付けて再試験、またはそのまま操縦</translation>
    </message>
    <message>
        <source>Lost radio means a robot that goes on</source>
        <translation>無線が切れてもロボットが走り続ける</translation>
    </message>
    <message>
        <source>Plug the cable in, or choose --interface</source>
        <translation>ケーブルを挿す、または --interface を指定</translation>
    </message>
    <message>
        <source>Make room, or record elsewhere (--mission)</source>
        <translation>空きを作る、または別の場所に記録 (--mission)</translation>
    </message>
    <message>
        <source>in order</source>
        <translation>正常</translation>
    </message>
    <message>
        <source>to know</source>
        <translation>参考</translation>
    </message>
    <message>
        <source>must be mended</source>
        <translation>要修正</translation>
    </message>
    <message>
        <source>needs a look</source>
        <translation>要確認</translation>
    </message>
    <message>
        <source>%1 to be mended</source>
        <translation>要修正 %1 件</translation>
    </message>
    <message>
        <source>%1 to be looked at</source>
        <translation>要確認 %1 件</translation>
    </message>
    <message>
        <source>All in order</source>
        <translation>すべて正常</translation>
    </message>
    <message>
        <source>Waits for drive control and standing ... keep holding</source>
        <translation>操縦権と静止を待機 ... 押し続ける</translation>
    </message>
    <message>
        <source>Drives ... keep holding</source>
        <translation>走行中 ... 押し続ける</translation>
    </message>
    <message>
        <source>Says nothing more, and measures ...</source>
        <translation>指令を断ち、計測中 ...</translation>
    </message>
    <message>
        <source>0.6 m must be free ahead</source>
        <translation>前方に 0.6 m の空きが必要</translation>
    </message>
    <message>
        <source>Passed: %1</source>
        <translation>合格: %1</translation>
    </message>
    <message>
        <source>FAILED: %1</source>
        <translation>不合格: %1</translation>
    </message>
    <message>
        <source>No result: %1</source>
        <translation>結果なし: %1</translation>
    </message>
    <message>
        <source>It may drop every drive command as too old: set its clock (NTP)</source>
        <translation>古すぎるとして走行コマンドをすべて捨てることがあります。時計を合わせてください (NTP)</translation>
    </message>
    <message>
        <source>the key was let go</source>
        <translation>キーが放されました</translation>
    </message>
    <message>
        <source>the robot was not to be driven any more</source>
        <translation>ロボットを走行させられなくなりました</translation>
    </message>
    <message>
        <source>nothing tells whether there is room ahead</source>
        <translation>前方に空きがあるか分かりません</translation>
    </message>
    <message>
        <source>only %1 m are free ahead, %2 m are needed</source>
        <translation>前方の空きは %1 m だけです（%2 m 必要）</translation>
    </message>
    <message>
        <source>the station may not drive the robot</source>
        <translation>このステーションはロボットを操縦できません</translation>
    </message>
    <message>
        <source>the robot hears no drive commands</source>
        <translation>ロボットに走行コマンドが届いていません</translation>
    </message>
    <message>
        <source>no odometry comes</source>
        <translation>オドメトリが届きません</translation>
    </message>
    <message>
        <source>the sticks were not let go</source>
        <translation>スティックが放されませんでした</translation>
    </message>
    <message>
        <source>the robot did not stand</source>
        <translation>ロボットが停止していませんでした</translation>
    </message>
    <message>
        <source>the robot did not come to its speed</source>
        <translation>ロボットが所定の速度に達しませんでした</translation>
    </message>
    <message>
        <source>no odometry came after the cut</source>
        <translation>コマンド停止後にオドメトリが届きませんでした</translation>
    </message>
    <message>
        <source>nothing tells why</source>
        <translation>理由は分かりません</translation>
    </message>
    <message>
        <source>Plug in a loudspeaker, then try the tones</source>
        <translation>スピーカーを接続し、音を試す</translation>
    </message>
    <message>
        <source>sound: there is a device; try the tones</source>
        <translation>音声: 装置あり。音を試してください</translation>
    </message>
    <message>
        <source>network set by ROS&apos;s environment: %1</source>
        <translation>ROS の環境変数によるネットワーク: %1</translation>
    </message>
    <message>
        <source>STOP is a zero command: it has no stop of its own, and obeys others, too</source>
        <translation>STOP は速度ゼロの指令です。独自の停止機能はなく、他の指令にも従います</translation>
    </message>
    <message>
        <source>STOP also locks %1</source>
        <translation>STOP は %1 もロックします</translation>
    </message>
    <message>
        <source>nobody listens to %1: STOP does not hold off what others send</source>
        <translation>%1 を受信する相手がいません：STOP は他からの指令を止められません</translation>
    </message>
    <message>
        <source>STOP also calls %1</source>
        <translation>STOP は %1 も呼び出します</translation>
    </message>
    <message>
        <source>nobody offers %1: STOP cannot call it</source>
        <translation>%1 を提供するノードがありません。STOP は呼び出せません</translation>
    </message>
    <message>
        <source>nobody tells where %1 sits: it counts as sitting at the robot&apos;s base</source>
        <translation>%1 の取付位置が不明です。ロボットの基準点にあるとみなします</translation>
    </message>
    <message>
        <source>Publish its transform (tf_static), or enter its place in the robot&apos;s file</source>
        <translation>その変換 (tf_static) を配信するか、ロボットのファイルに位置を書いてください</translation>
    </message>
</context>
<context>
    <name>leitstand::PreflightPage</name>
    <message>
        <source>Checks before the mission</source>
        <translation>ミッション前の点検</translation>
    </message>
    <message>
        <source>Check again</source>
        <translation>再点検</translation>
    </message>
    <message>
        <source>Measures the disk again; everything else is checked once a second</source>
        <translation>ディスクを再計測。その他は毎秒確認</translation>
    </message>
    <message>
        <source>Robot whose brake is tested</source>
        <translation>ブレーキを試験するロボット</translation>
    </message>
    <message>
        <source>Hold to test the brake</source>
        <translation>押し続けてブレーキ試験</translation>
    </message>
    <message>
        <source>Drives 0.1 m/s ahead for a second at most, then sends nothing and measures when the robot stands. Letting go ends it; Esc stops all.</source>
        <translation>0.1 m/s で最長 1 秒前進し、その後は何も送らずにロボットが止まるまでを計測。放すと終了、Esc で全停止。</translation>
    </message>
    <message>
        <source>Drive it nevertheless</source>
        <translation>それでも操縦する</translation>
    </message>
    <message>
        <source>This robot goes on when the radio is lost. Until the program ends.</source>
        <translation>このロボットは無線が切れても走り続ける。プログラム終了まで有効。</translation>
    </message>
    <message>
        <source>Brake test</source>
        <translation>ブレーキ試験</translation>
    </message>
    <message>
        <source>Robots that are heard and not driven</source>
        <translation>受信中で操縦対象外のロボット</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>追加</translation>
    </message>
    <message>
        <source>Writes a first file of the robot and takes it into the station</source>
        <translation>ロボットの初期ファイルを作成し、操作卓に追加</translation>
    </message>
    <message>
        <source>From a file...</source>
        <translation>ファイルから...</translation>
    </message>
    <message>
        <source>A robot file (YAML)</source>
        <translation>ロボットファイル (YAML)</translation>
    </message>
    <message>
        <source>Another robot</source>
        <translation>別のロボット</translation>
    </message>
    <message>
        <source>Try the tones</source>
        <translation>音を試す</translation>
    </message>
    <message>
        <source>Plays the tones of alarms: to look, then to act</source>
        <translation>警報音を鳴らす: 注意、次に対処</translation>
    </message>
</context>
<context>
    <name>leitstand::ReadingRowsModel</name>
    <message>
        <source>Reading</source>
        <translation>測定値</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>値</translation>
    </message>
    <message>
        <source>Limits</source>
        <translation>限界</translation>
    </message>
    <message>
        <source>Age</source>
        <translation>経過</translation>
    </message>
    <message>
        <source>Amber outside %1</source>
        <translation>%1 の外で黄</translation>
    </message>
    <message>
        <source>Red outside %1</source>
        <translation>%1 の外で赤</translation>
    </message>
</context>
<context>
    <name>leitstand::ReadingWords</name>
    <message>
        <source>%1 to %2</source>
        <translation>%1～%2</translation>
    </message>
</context>
<context>
    <name>leitstand::Readings</name>
    <message>
        <source>temperature</source>
        <translation>温度</translation>
    </message>
    <message>
        <source>humidity</source>
        <translation>湿度</translation>
    </message>
    <message>
        <source>pressure</source>
        <translation>気圧</translation>
    </message>
    <message>
        <source>magnetic field</source>
        <translation>磁場</translation>
    </message>
    <message>
        <source>distance</source>
        <translation>距離</translation>
    </message>
    <message>
        <source>light</source>
        <translation>照度</translation>
    </message>
    <message>
        <source>latitude</source>
        <translation>緯度</translation>
    </message>
    <message>
        <source>longitude</source>
        <translation>経度</translation>
    </message>
    <message>
        <source>altitude</source>
        <translation>高度</translation>
    </message>
</context>
<context>
    <name>leitstand::ReadingsFeature</name>
    <message>
        <source>&amp;Readings of its sensors</source>
        <translation>センサーの測定値(&amp;R)</translation>
    </message>
    <message>
        <source>Temperatures, distances and all other numbers that the robot&apos;s file names, with their limits</source>
        <translation>ロボットのファイルに記された温度・距離などの数値と、その限界</translation>
    </message>
</context>
<context>
    <name>leitstand::ReadingsPanel</name>
    <message>
        <source>Readings</source>
        <translation>測定値</translation>
    </message>
    <message>
        <source>Readings of the robot&apos;s sensors</source>
        <translation>ロボットのセンサーの測定値</translation>
    </message>
    <message>
        <source>This robot&apos;s file names no readings</source>
        <translation>このロボットのファイルには測定値がありません</translation>
    </message>
</context>
<context>
    <name>leitstand::RecordLight</name>
    <message>
        <source>Recording</source>
        <translation>記録</translation>
    </message>
</context>
<context>
    <name>leitstand::RecordText</name>
    <message>
        <source>Recorded into %1</source>
        <translation>%1 に記録</translation>
    </message>
    <message>
        <source>%1 MB in this session</source>
        <translation>このセッションで %1 MB</translation>
    </message>
    <message>
        <source>rec</source>
        <translation>記録中</translation>
    </message>
    <message>
        <source>the disk lasts %1 min</source>
        <translation>ディスクの残り %1 min</translation>
    </message>
    <message>
        <source>rec · disk %1 min</source>
        <translation>記録中 · ディスク %1 min</translation>
    </message>
    <message>
        <source>rec · %1 lost</source>
        <translation>記録中 · 欠落 %1</translation>
    </message>
    <message>
        <source>%1 events could not be written</source>
        <translation>イベント %1 件を書き込めなかった</translation>
    </message>
    <message>
        <source>not recording</source>
        <translation>記録していない</translation>
    </message>
</context>
<context>
    <name>leitstand::RegistrationCommands</name>
    <message>
        <source>Register &amp;again</source>
        <translation>再度位置合わせ(&amp;A)</translation>
    </message>
    <message>
        <source>Registers all scans again with the present settings</source>
        <translation>現在の設定で全スキャンの位置合わせをやり直す</translation>
    </message>
    <message>
        <source>&amp;Cancel</source>
        <translation>中止(&amp;C)</translation>
    </message>
    <message>
        <source>Ends reading and registering</source>
        <translation>読み込みと位置合わせを終了</translation>
    </message>
</context>
<context>
    <name>leitstand::RegistrationPanel</name>
    <message>
        <source>M&amp;inimise</source>
        <translation>最小化(&amp;I)</translation>
    </message>
    <message>
        <source>&amp;Nearest points</source>
        <translation>最近傍点(&amp;N)</translation>
    </message>
    <message>
        <source>A&amp;pproximation ε</source>
        <translation>近似 ε(&amp;P)</translation>
    </message>
    <message>
        <source>The point found is at most (1 + ε) times as far as the nearest one (Arya &amp; Mount 1993); 0: exact. Applies to the approximate tree and the forest.</source>
        <translation>見つかる点は最近傍点の最大 (1 + ε) 倍の距離 (Arya &amp; Mount 1993)。0: 厳密。近似木とフォレストに適用。</translation>
    </message>
    <message>
        <source>Pairs of points farther apart are dropped. Several values are stages, one after another: &quot;1.5, 0.5&quot; comes home from starts that are up to 1 m and 20° wrong.</source>
        <translation>これより離れた点対は捨てる。複数の値は段階として順に適用: &quot;1.5, 0.5&quot; なら初期値が最大 1 m、20° ずれていても収束する。</translation>
    </message>
    <message>
        <source>0.01 to 10 m, each at most the one before: 1.5, 0.5</source>
        <translation>0.01～10 m、各値は前の値以下: 1.5, 0.5</translation>
    </message>
    <message>
        <source>Steps at m&amp;ost</source>
        <translation>最大反復数(&amp;O)</translation>
    </message>
    <message>
        <source>Iterations of the ICP for a scan, over all stages.</source>
        <translation>スキャン 1 件あたりの ICP 反復数（全段階）。</translation>
    </message>
    <message>
        <source>m</source>
        <translation>m</translation>
    </message>
    <message>
        <source>all points</source>
        <translation>全点</translation>
    </message>
    <message>
        <source>Voxe&amp;ls</source>
        <translation>ボクセル(&amp;L)</translation>
    </message>
    <message>
        <source>Fil&amp;ter</source>
        <translation>フィルタ(&amp;T)</translation>
    </message>
    <message>
        <source>to</source>
        <translation>～</translation>
    </message>
    <message>
        <source>Ran&amp;ge</source>
        <translation>距離範囲(&amp;G)</translation>
    </message>
    <message>
        <source>Points nearer than the first (the robot itself) and farther than the second (no echo) take no part.</source>
        <translation>1 つ目より近い点（ロボット自身）と 2 つ目より遠い点（反射なし）は使わない。</translation>
    </message>
    <message>
        <source>&amp;Start from</source>
        <translation>初期位置(&amp;S)</translation>
    </message>
    <message>
        <source>Match &amp;against</source>
        <translation>照合先(&amp;A)</translation>
    </message>
    <message>
        <source>all cores</source>
        <translation>全コア</translation>
    </message>
    <message>
        <source>Thr&amp;eads</source>
        <translation>スレッド(&amp;E)</translation>
    </message>
    <message>
        <source>How many processor cores may work at once.</source>
        <translation>同時に使うプロセッサコア数。</translation>
    </message>
    <message>
        <source>Defa&amp;ults</source>
        <translation>既定値(&amp;U)</translation>
    </message>
    <message>
        <source>Puts every setting back to where it was at first.</source>
        <translation>すべての設定を初期値に戻す。</translation>
    </message>
    <message>
        <source>Maximum &amp;distance</source>
        <translation>最大距離(&amp;D)</translation>
    </message>
    <message>
        <source>Edge of the voxel grid: one point is kept in each voxel. 0 uses all points. A grid of 10 cm moves the result by some centimetres and takes a fraction of the time.</source>
        <translation>ボクセルグリッドの辺長: 各ボクセルに 1 点を残す。0 は全点を使用。10 cm のグリッドでは結果が数センチ変わるが、時間は何分の 1 かで済む。</translation>
    </message>
</context>
<context>
    <name>leitstand::RegistrationSettings</name>
    <message>
        <source>Brute force</source>
        <translation>総当たり</translation>
    </message>
    <message>
        <source>Compares every point with every point: exact and very slow (first row of the paper&apos;s Table 1). Reduce the points first.</source>
        <translation>全点同士を比較: 厳密だが非常に遅い（論文の表 1 の 1 行目）。先に点を減らすこと。</translation>
    </message>
    <message>
        <source>k-d tree</source>
        <translation>k-d 木</translation>
    </message>
    <message>
        <source>Exact search in an optimised k-d tree (Friedman, Bentley &amp; Finkel 1977).</source>
        <translation>最適化 k-d 木での厳密な探索 (Friedman, Bentley &amp; Finkel 1977)。</translation>
    </message>
    <message>
        <source>Approximate k-d tree</source>
        <translation>近似 k-d 木</translation>
    </message>
    <message>
        <source>A k-d tree that may answer a point up to (1 + ε) times as far as the nearest (Arya &amp; Mount 1993).</source>
        <translation>最近傍の最大 (1 + ε) 倍の距離の点を返しうる k-d 木 (Arya &amp; Mount 1993)。</translation>
    </message>
    <message>
        <source>Forest, a tree per label</source>
        <translation>フォレスト、ラベル別の木</translation>
    </message>
    <message>
        <source>Floor, wall and ceiling points look for their own kind only, each in an approximate tree of its own (the paper, section 2.2).</source>
        <translation>床・壁・天井の点は同種の点だけを、それぞれの近似木で探索（論文の 2.2 節）。</translation>
    </message>
    <message>
        <source>Points · SVD</source>
        <translation>点 · SVD</translation>
    </message>
    <message>
        <source>Point to point, closed form by singular value decomposition (Arun, Huang &amp; Blostein 1987).</source>
        <translation>点対点、特異値分解による閉形式解 (Arun, Huang &amp; Blostein 1987)。</translation>
    </message>
    <message>
        <source>Points · unit quaternion</source>
        <translation>点 · 単位四元数</translation>
    </message>
    <message>
        <source>Point to point, closed form by unit quaternions (Horn 1987).</source>
        <translation>点対点、単位四元数による閉形式解 (Horn 1987)。</translation>
    </message>
    <message>
        <source>Points · orthonormal matrix</source>
        <translation>点 · 正規直交行列</translation>
    </message>
    <message>
        <source>Point to point, closed form by orthonormal matrices (Horn, Hilden &amp; Negahdaripour 1988).</source>
        <translation>点対点、正規直交行列による閉形式解 (Horn, Hilden &amp; Negahdaripour 1988)。</translation>
    </message>
    <message>
        <source>Points · dual quaternion</source>
        <translation>点 · 双対四元数</translation>
    </message>
    <message>
        <source>Point to point, closed form by dual quaternions (Walker, Shao &amp; Volz 1991).</source>
        <translation>点対点、双対四元数による閉形式解 (Walker, Shao &amp; Volz 1991)。</translation>
    </message>
    <message>
        <source>Point to plane</source>
        <translation>点対面</translation>
    </message>
    <message>
        <source>Distances to the planes of the reference: fewer steps on walls and floors (Chen &amp; Medioni 1991).</source>
        <translation>基準側の平面までの距離: 壁や床で反復が少ない (Chen &amp; Medioni 1991)。</translation>
    </message>
    <message>
        <source>Plane to plane (GICP)</source>
        <translation>面対面 (GICP)</translation>
    </message>
    <message>
        <source>Distances between small planes of both scans: fewest steps, hardly depends on the maximum distance (Segal, Haehnel &amp; Thrun 2009).</source>
        <translation>両スキャンの小平面間の距離: 反復が最も少なく、最大距離にほとんど依存しない (Segal, Haehnel &amp; Thrun 2009)。</translation>
    </message>
    <message>
        <source>None</source>
        <translation>なし</translation>
    </message>
    <message>
        <source>All points go on to the voxels.</source>
        <translation>全点をボクセルへ渡す。</translation>
    </message>
    <message>
        <source>Median and reduction</source>
        <translation>メディアンと削減</translation>
    </message>
    <message>
        <source>The paper&apos;s filter for organised scans: outliers of a raw scan become the median of their neighbours, close points are joined.</source>
        <translation>整列スキャン用の論文のフィルタ: 生スキャンの外れ値を近傍のメディアンに置き換え、近い点をまとめる。</translation>
    </message>
    <message>
        <source>Odometry</source>
        <translation>オドメトリ</translation>
    </message>
    <message>
        <source>Each scan starts where the robot&apos;s odometry puts it after the scan before.</source>
        <translation>各スキャンの初期位置は、前のスキャンからロボットのオドメトリで求める。</translation>
    </message>
    <message>
        <source>Pose of the scan before</source>
        <translation>前のスキャンの位置姿勢</translation>
    </message>
    <message>
        <source>Each scan starts at the registered pose of the scan before: for scans without odometry.</source>
        <translation>各スキャンの初期位置は、前のスキャンの位置合わせ結果: オドメトリのないスキャン用。</translation>
    </message>
    <message>
        <source>Previous scan</source>
        <translation>前のスキャン</translation>
    </message>
    <message>
        <source>Each scan is matched against the one before it.</source>
        <translation>各スキャンを直前のスキャンと照合。</translation>
    </message>
    <message>
        <source>Whole map</source>
        <translation>地図全体</translation>
    </message>
    <message>
        <source>Each scan is matched against all scans so far (metascan): slower, drifts less.</source>
        <translation>各スキャンをそれまでの全スキャンと照合（メタスキャン）: 遅いが、ドリフトが少ない。</translation>
    </message>
</context>
<context>
    <name>leitstand::ReleaseHandle</name>
    <message>
        <source>Release %1</source>
        <translation>%1 を解除</translation>
    </message>
    <message>
        <source>%1 · hold to release</source>
        <translation>%1 · 押し続けて解除</translation>
    </message>
    <message>
        <source>Hold this button for one second to let %1 move again.</source>
        <translation>このボタンを 1 秒押し続けると %1 を再び動かせる。</translation>
    </message>
</context>
<context>
    <name>leitstand::ReportFeature</name>
    <message>
        <source>Mission d&amp;ata…</source>
        <translation>ミッション情報(&amp;A)…</translation>
    </message>
    <message>
        <source>Competition, team, operators, rules of the score: what the report says</source>
        <translation>競技会、チーム、操縦者数、採点規則: 報告書に載る内容</translation>
    </message>
    <message>
        <source>&amp;Report into a folder…</source>
        <translation>フォルダーへ報告(&amp;R)…</translation>
    </message>
    <message>
        <source>Writes the judges&apos; folder now, and again every minute</source>
        <translation>審判用フォルダーを今書き出し、以後毎分更新する</translation>
    </message>
    <message>
        <source>The report is not written any more</source>
        <translation>報告書の更新を終了した</translation>
    </message>
    <message>
        <source>Folder for the report</source>
        <translation>報告書のフォルダー</translation>
    </message>
    <message>
        <source>The report goes on into %1</source>
        <translation>報告書を引き続き %1 に書き出す</translation>
    </message>
    <message>
        <source>Report</source>
        <translation>報告書</translation>
    </message>
</context>
<context>
    <name>leitstand::ReportText</name>
    <message>
        <source>{}: its {} is missing: {}</source>
        <translation>{}: {} がありません: {}</translation>
    </message>
    <message>
        <source>{}: its {} cannot be shown: {}</source>
        <translation>{}: {} を表示できません: {}</translation>
    </message>
    <message>
        <source>the mission holds no events</source>
        <translation>このミッションにはイベントがありません</translation>
    </message>
    <message>
        <source>{} samples of {} make no sense, the last one: {}</source>
        <translation>{} 件の {} のデータが不正です。最後のもの: {}</translation>
    </message>
    <message>
        <source>there is no map: all scans of the mission were set aside or taken back</source>
        <translation>地図がありません: ミッションの全スキャンが除外または取り消されました</translation>
    </message>
    <message>
        <source>{} scans are not in the map, since they do not fit and nobody decided on them</source>
        <translation>{} 個のスキャンは合わず、判断もされていないため地図に入っていません</translation>
    </message>
    <message>
        <source>there is no map: {}</source>
        <translation>地図がありません: {}</translation>
    </message>
    <message>
        <source>no station made a map of this mission: {} of its {} scans were registered for this report, without anyone&apos;s check</source>
        <translation>このミッションの地図を作ったステーションがありません: {} / {} スキャンをこの報告のために位置合わせしました(未確認)</translation>
    </message>
    <message>
        <source>cameras looked from more places than are counted: {} views are missing in what was searched</source>
        <translation>カメラの視点が数えられる数を超えました: 探索済みの集計に {} 視点が含まれていません</translation>
    </message>
    <message>
        <source>the score&apos;s profile &quot;{}&quot; is not there: &quot;{}&quot; is used</source>
        <translation>採点プロファイル「{}」がありません: 「{}」を使います</translation>
    </message>
    <message>
        <source>there is no map: no scan of the mission counts</source>
        <translation>地図がありません: 有効なスキャンがありません</translation>
    </message>
    <message>
        <source>without a map there are no GeoTIFF, OctoMap, PLY and pages of the map</source>
        <translation>地図がないため、GeoTIFF、OctoMap、PLY、地図ページはない</translation>
    </message>
    <message>
        <source>not confirmed, so in the map but not in the lists: {}</source>
        <translation>未確認のため地図にはあるが一覧にはないもの: {}</translation>
    </message>
    <message>
        <source>competition or team are not given: the files are named for what is missing</source>
        <translation>大会名またはチーム名が未設定です: ファイル名は仮の名前になっています</translation>
    </message>
    <message>
        <source>picture</source>
        <translation>画像</translation>
    </message>
    <message>
        <source>infrared picture</source>
        <translation>赤外線画像</translation>
    </message>
    <message>
        <source>CO₂ value</source>
        <translation>CO₂値</translation>
    </message>
    <message>
        <source>scan</source>
        <translation>スキャン</translation>
    </message>
    <message>
        <source>robot&apos;s pose</source>
        <translation>ロボットの姿勢</translation>
    </message>
    <message>
        <source>{} of an earlier report cannot be removed: {}</source>
        <translation>以前の報告書の {} を削除できません: {}</translation>
    </message>
    <message>
        <source>Report written into {}</source>
        <translation>報告書を {} に書き出しました</translation>
    </message>
    <message>
        <source>The report in {} is not whole: {}</source>
        <translation>{} の報告書は不完全です: {}</translation>
    </message>
    <message>
        <source>{} of {} scans are of parts of the map that have not met the rest: they lie aside in it, since nobody knows where they belong</source>
        <translation>{}/{}のスキャンは、残りの地図とまだ結合していない部分のものです。位置が分からないため、離して置いてあります</translation>
    </message>
</context>
<context>
    <name>leitstand::ReviewComparison</name>
    <message>
        <source>Registering again was cancelled</source>
        <translation>再レジストレーションを中止</translation>
    </message>
</context>
<context>
    <name>leitstand::ReviewReport</name>
    <message>
        <source>The report is being written into %1</source>
        <translation>報告書を %1 に書き出している</translation>
    </message>
</context>
<context>
    <name>leitstand::ReviewWindow</name>
    <message>
        <source>%1 – review – Leitstand</source>
        <translation>%1 – レビュー – Leitstand</translation>
    </message>
    <message>
        <source>&amp;Register again…</source>
        <translation>再度位置合わせ(&amp;R)…</translation>
    </message>
    <message>
        <source>Registers the mission&apos;s scans again, in a window of its own, with settings of your own; the mission stays as it is</source>
        <translation>ミッションのスキャンを別ウィンドウで独自の設定により位置合わせし直す。ミッションは変わらない</translation>
    </message>
    <message>
        <source>REVIEW · %1</source>
        <translation>レビュー · %1</translation>
    </message>
    <message>
        <source>the mission is still read through</source>
        <translation>ミッションを読み込み中</translation>
    </message>
    <message>
        <source>The map is being tidied. The review opens again then.</source>
        <translation>地図を整えています。終わるとレビューを開き直します。</translation>
    </message>
    <message>
        <source>The tidying is taken back. The review opens again then.</source>
        <translation>地図の整えを取り消しています。終わるとレビューを開き直します。</translation>
    </message>
    <message>
        <source>Being cancelled…</source>
        <translation>中止しています…</translation>
    </message>
    <message>
        <source>How the maps of %1 and %2 lie to each other is not sure: they lie side by side. A station that goes on with this mission joins them by hand</source>
        <translation>%1と%2の地図の位置関係は確かではないため、並べて置いてあります。このミッションを続けるステーションで手作業で結合できます</translation>
    </message>
    <message>
        <source>The maps of %1 and %2 are one: of %3 places that were looked for, %4 agree</source>
        <translation>%1と%2の地図を1つにしました。探した%3か所のうち%4か所が一致しました</translation>
    </message>
    <message>
        <source>The maps of %1 and %2 are being merged. The new mission opens then.</source>
        <translation>%1と%2の地図を統合しています。その後、新しいミッションが開きます。</translation>
    </message>
    <message>
        <source>&amp;Merge with the map of…</source>
        <translation>別の地図と統合(&amp;M)…</translation>
    </message>
    <message>
        <source>Brings the maps of this mission and another one into a new mission, where they have seen the same places; both stay as they are</source>
        <translation>このミッションと別のミッションの地図を、同じ場所を見た所で合わせて新しいミッションにします。元の2つはそのまま残ります</translation>
    </message>
    <message>
        <source>Merge with the map of…</source>
        <translation>別の地図と統合…</translation>
    </message>
    <message>
        <source>That is this mission: its map is merged with that of another one</source>
        <translation>それはこのミッションです。別のミッションの地図を選んでください</translation>
    </message>
    <message>
        <source>A report is being written, or scans are being registered again: merge after that</source>
        <translation>報告書の作成中か、スキャンの再登録中です。その後で統合してください</translation>
    </message>
    <message>
        <source>; key scans in parts that were mapped apart and are not in it: %1</source>
        <translation>、別々に作成され含まれていない部分のキースキャン: %1</translation>
    </message>
    <message>
        <source>Correct the map by &amp;hand…</source>
        <translation>地図を手動で修正(&amp;H)…</translation>
    </message>
    <message>
        <source>Moves parts of the map, answers where it meets itself, accepts, rejects and registers scans again, in a window of its own; the review is opened again then. What was recorded stays as it is, and each decision can be taken back</source>
        <translation>専用のウィンドウで、地図の一部を動かし、地図が重なる場所の問いに答え、スキャンを採用・除外・再位置合わせします。その後、レビューが再び開きます。記録されたものはそのまま残り、どの決定も取り消せます</translation>
    </message>
    <message>
        <source>A report is being written, or scans are being registered again: correct the map after that</source>
        <translation>レポートの書き出し中、またはスキャンの再位置合わせ中です。終わってから地図を修正してください</translation>
    </message>
</context>
<context>
    <name>leitstand::RobotBar</name>
    <message>
        <source>Robots</source>
        <translation>ロボット</translation>
    </message>
</context>
<context>
    <name>leitstand::RobotBodies</name>
    <message>
        <source>{}: {} meshes of its model are not on this computer, simple shapes are drawn instead ({}). Name the folder with its packages in the robot&apos;s file: packages</source>
        <translation>{}: モデルのメッシュ {} 個がこのコンピューターにないため、単純な形で描きます ({})。パッケージのフォルダーをロボットのファイルの packages に書いてください</translation>
    </message>
    <message>
        <source>{}: its model is not drawn: {}</source>
        <translation>{}: モデルを描けません: {}</translation>
    </message>
    <message>
        <source>it reaches farther than {} m from its base</source>
        <translation>ベースから {} m を超えて広がっています</translation>
    </message>
</context>
<context>
    <name>leitstand::RobotChip</name>
    <message>
        <source>%1 (%2): %3 · link %4</source>
        <translation>%1（%2）: %3 · 通信 %4</translation>
    </message>
    <message>
        <source>battery %1</source>
        <translation>バッテリー %1</translation>
    </message>
    <message>
        <source>battery %1, %2</source>
        <translation>バッテリー %1、%2</translation>
    </message>
    <message>
        <source>lost</source>
        <translation>途絶</translation>
    </message>
    <message>
        <source>waits</source>
        <comment>for the robot</comment>
        <translation>待機</translation>
    </message>
</context>
<context>
    <name>leitstand::RobotChipButton</name>
    <message>
        <source>%1 selects</source>
        <translation>%1 で選択</translation>
    </message>
    <message>
        <source>Robot %1</source>
        <translation>ロボット %1</translation>
    </message>
</context>
<context>
    <name>leitstand::RobotMark</name>
    <message>
        <source>place certain to %1</source>
        <translation>位置の確度 %1</translation>
    </message>
    <message>
        <source>place uncertain, %1</source>
        <translation>位置不確実、確度 %1</translation>
    </message>
    <message>
        <source>place uncertain</source>
        <translation>位置不確実</translation>
    </message>
    <message>
        <source>link lost: seen here last</source>
        <translation>通信断: 最後に確認した位置</translation>
    </message>
    <message>
        <source>%1 is not in the map yet</source>
        <translation>%1 はまだ地図にない</translation>
    </message>
    <message>
        <source>%1 is not in the map yet · %2 places it</source>
        <translation>%1 はまだ地図にない · %2 で配置</translation>
    </message>
</context>
<context>
    <name>leitstand::RobotRow</name>
    <message>
        <source>%1 · STOP: %2</source>
        <comment>a robot, all of its state, its stop</comment>
        <translation>%1 · STOP: %2</translation>
    </message>
</context>
<context>
    <name>leitstand::RobotSays</name>
    <message>
        <source>started</source>
        <translation>起動した</translation>
    </message>
    <message>
        <source>asked for</source>
        <translation>要求による</translation>
    </message>
    <message>
        <source>{} cannot be asked for</source>
        <translation>{} は要求できない</translation>
    </message>
    <message>
        <source>expected a mode, found &quot;{}&quot;</source>
        <translation>モードではない: &quot;{}&quot;</translation>
    </message>
    <message>
        <source>the stop stands: release it first</source>
        <translation>停止中: 先に解除する</translation>
    </message>
    <message>
        <source>the radio remote is in use</source>
        <translation>無線リモコン使用中</translation>
    </message>
    <message>
        <source>the radio remote was let go of</source>
        <translation>無線リモコンを放した</translation>
    </message>
    <message>
        <source>no body heat in sight</source>
        <translation>体温が見えない</translation>
    </message>
    <message>
        <source>body heat in sight</source>
        <translation>体温を発見</translation>
    </message>
    <message>
        <source>stop</source>
        <translation>停止</translation>
    </message>
    <message>
        <source>stopped by {}</source>
        <translation>{} が停止させた</translation>
    </message>
    <message>
        <source>its own button</source>
        <translation>本体のボタン</translation>
    </message>
    <message>
        <source>released</source>
        <translation>解除された</translation>
    </message>
    <message>
        <source>the link is back</source>
        <translation>通信回復</translation>
    </message>
    <message>
        <source>the link is back: goes on</source>
        <translation>通信回復: 続行</translation>
    </message>
    <message>
        <source>the link is back: waits to be asked again</source>
        <translation>通信回復: 再指示待ち</translation>
    </message>
    <message>
        <source>link lost: stands</source>
        <translation>通信途絶: 停止</translation>
    </message>
    <message>
        <source>link lost: finishes what it does, then waits</source>
        <translation>通信途絶: 作業を終えて待機</translation>
    </message>
    <message>
        <source>link lost: returns to where it was good</source>
        <translation>通信途絶: 良好だった場所へ戻る</translation>
    </message>
    <message>
        <source>link lost: finished, waits</source>
        <translation>通信途絶: 完了、待機</translation>
    </message>
    <message>
        <source>link lost: waits</source>
        <translation>通信途絶: 待機</translation>
    </message>
    <message>
        <source>link lost: is back where it was good, waits</source>
        <translation>通信途絶: 良好だった場所に戻り待機</translation>
    </message>
    <message>
        <source>link lost: finds no way back, waits</source>
        <translation>通信途絶: 戻り道なし、待機</translation>
    </message>
    <message>
        <source>back where the link was good</source>
        <translation>通信が良好だった場所に戻った</translation>
    </message>
    <message>
        <source>the scanner is silent: stands</source>
        <translation>スキャナ無応答: 停止</translation>
    </message>
    <message>
        <source>looks around first</source>
        <translation>まず周囲を確認</translation>
    </message>
    <message>
        <source>at the goal</source>
        <translation>目標に到着</translation>
    </message>
    <message>
        <source>finds no way: looks again</source>
        <translation>経路なし: 再確認</translation>
    </message>
    <message>
        <source>finds no way to the goal</source>
        <translation>目標への経路なし</translation>
    </message>
    <message>
        <source>nothing is left to explore</source>
        <translation>探索完了</translation>
    </message>
    <message>
        <source>stuck: makes room</source>
        <translation>立ち往生: 後退して余裕を作る</translation>
    </message>
    <message>
        <source>looks for a way</source>
        <translation>経路を探索</translation>
    </message>
    <message>
        <source>ran against something: backs out</source>
        <translation>接触: 後退する</translation>
    </message>
    <message>
        <source>leans too much: backs out</source>
        <translation>傾きすぎ: 後退する</translation>
    </message>
    <message>
        <source>finds no way off what it ran into</source>
        <translation>障害物から離れられない</translation>
    </message>
    <message>
        <source>rolled over: stands</source>
        <translation>転倒: 停止</translation>
    </message>
    <message>
        <source>no rule applies: stands</source>
        <translation>該当規則なし: 停止</translation>
    </message>
    <message>
        <source>no heat to drive to</source>
        <translation>向かう熱源なし</translation>
    </message>
    <message>
        <source>the heat was lost</source>
        <translation>熱源を見失った</translation>
    </message>
    <message>
        <source>the heat cannot be reached</source>
        <translation>熱源に到達できない</translation>
    </message>
    <message>
        <source>that victim is known</source>
        <translation>既知の被災者</translation>
    </message>
    <message>
        <source>gave the approach up</source>
        <translation>接近を断念</translation>
    </message>
    <message>
        <source>turns to the heat</source>
        <translation>熱源に向きを変える</translation>
    </message>
    <message>
        <source>drives towards the heat</source>
        <translation>熱源へ走行</translation>
    </message>
    <message>
        <source>drives around what stands before the heat</source>
        <translation>熱源手前の障害物を迂回</translation>
    </message>
    <message>
        <source>measures again</source>
        <translation>再計測</translation>
    </message>
    <message>
        <source>heat {} m ahead</source>
        <translation>前方 {} m に熱源</translation>
    </message>
    <message>
        <source>stands in front of a victim</source>
        <translation>被災者の前で停止</translation>
    </message>
    <message>
        <source>stands {} m in front of a victim</source>
        <translation>被災者の {} m 手前で停止</translation>
    </message>
    <message>
        <source>the wish is no number</source>
        <translation>指令が数値でない</translation>
    </message>
    <message>
        <source>obstacle in {} m</source>
        <translation>{} m 先に障害物</translation>
    </message>
    <message>
        <source>the scan there is {} s old</source>
        <translation>その方向のスキャンは {} 秒前</translation>
    </message>
    <message>
        <source>not seen there yet</source>
        <translation>その方向は未観測</translation>
    </message>
    <message>
        <source>roll-over</source>
        <translation>転倒</translation>
    </message>
    <message>
        <source>upright</source>
        <translation>正立</translation>
    </message>
    <message>
        <source>about to roll over</source>
        <translation>転倒の恐れ</translation>
    </message>
    <message>
        <source>rolled over</source>
        <translation>転倒した</translation>
    </message>
    <message>
        <source>front</source>
        <translation>前</translation>
    </message>
    <message>
        <source>left</source>
        <translation>左</translation>
    </message>
    <message>
        <source>rear</source>
        <translation>後</translation>
    </message>
    <message>
        <source>right</source>
        <translation>右</translation>
    </message>
    <message>
        <source>body heat, {} degrees C</source>
        <translation>体温 {} °C</translation>
    </message>
    <message>
        <source>sticks must be neutral first</source>
        <translation>先にスティックを中立へ</translation>
    </message>
    <message>
        <source>the heat is hidden from here</source>
        <translation>ここからは熱源が隠れている</translation>
    </message>
    <message>
        <source>warm, but no person: no clothes beside the heat</source>
        <translation>温かいが人ではない：そばに衣服がない</translation>
    </message>
</context>
<context>
    <name>leitstand::RobotsFeature</name>
    <message>
        <source>Select %1	%2</source>
        <translation>%1 を選択	%2</translation>
    </message>
    <message>
        <source>Select %1</source>
        <translation>%1 を選択</translation>
    </message>
    <message>
        <source>&amp;Stop all robots	Esc</source>
        <translation>全ロボットを停止(&amp;S)	Esc</translation>
    </message>
    <message>
        <source>All robots stand until each is released</source>
        <translation>個別に解除するまで全ロボットが停止</translation>
    </message>
    <message>
        <source>&amp;Mode</source>
        <translation>モード(&amp;M)</translation>
    </message>
    <message>
        <source>The robot has reported none yet</source>
        <translation>ロボットからの通知はまだない</translation>
    </message>
</context>
<context>
    <name>leitstand::RobotsOnMap</name>
    <message>
        <source>Next way to &amp;follow</source>
        <translation>次の追従方法(&amp;F)</translation>
    </message>
    <message>
        <source>The map stands still, follows the selected robot from behind, or from above</source>
        <translation>地図を固定、選択中のロボットを後方から追従、または上方から追従</translation>
    </message>
    <message>
        <source>Map stands &amp;still</source>
        <translation>地図を固定(&amp;S)</translation>
    </message>
    <message>
        <source>The mouse alone moves the map</source>
        <translation>地図はマウスでのみ動く</translation>
    </message>
    <message>
        <source>Follow from be&amp;hind</source>
        <translation>後方から追従(&amp;H)</translation>
    </message>
    <message>
        <source>The camera stays behind and above the selected robot; ceilings are hidden</source>
        <translation>視点は選択中のロボットの後上方。天井は非表示</translation>
    </message>
    <message>
        <source>Follow from a&amp;bove</source>
        <translation>上方から追従(&amp;B)</translation>
    </message>
    <message>
        <source>The camera stays above the selected robot, its heading up; ceilings are hidden</source>
        <translation>視点は選択中のロボットの真上、進行方向が上。天井は非表示</translation>
    </message>
    <message>
        <source>What robots &amp;draw</source>
        <translation>ロボットの描画(&amp;D)</translation>
    </message>
    <message>
        <source>Markers, outlines, detections and places that robots publish, over the map</source>
        <translation>ロボットが発行するマーカー・輪郭・検出・位置を地図に重ねて表示</translation>
    </message>
    <message>
        <source>Robots as their &amp;models</source>
        <translation>ロボットをモデルで表示(&amp;M)</translation>
    </message>
    <message>
        <source>Robots that publish their model (robot_description) are drawn by it, with their joints; others as symbols</source>
        <translation>モデル (robot_description) を発行するロボットは、関節を含めてモデルで描きます。ほかは記号で描きます</translation>
    </message>
</context>
<context>
    <name>leitstand::ScanDoubt</name>
    <message>
        <source>little overlap</source>
        <translation>重なり不足</translation>
    </message>
    <message>
        <source>Little overlap: few of its points meet the map. Where it shows new ground, accept it if its walls go on in line.</source>
        <translation>重なり不足: 地図と合う点が少ない。新しい場所なら、壁が一直線に続いていれば採用する。</translation>
    </message>
    <message>
        <source>bad fit</source>
        <translation>不適合</translation>
    </message>
    <message>
        <source>Bad fit: points that meet the map lie off it. Retry, or reject it.</source>
        <translation>不適合: 地図と合うべき点がずれている。再試行、または除外する。</translation>
    </message>
    <message>
        <source>jump</source>
        <translation>飛び</translation>
    </message>
    <message>
        <source>Jump: it moved otherwise than the wheels say. They may have slipped: look whether walls double.</source>
        <translation>飛び: 車輪の値と異なる動き。滑りの可能性: 壁が二重になっていないか確認する。</translation>
    </message>
    <message>
        <source>open direction</source>
        <translation>拘束不足</translation>
    </message>
    <message>
        <source>Open direction: it fits as well when shifted some way, as in a corridor.</source>
        <translation>拘束不足: 通路のように、ある方向にずらしても同じく適合する。</translation>
    </message>
    <message>
        <source>no end</source>
        <translation>未収束</translation>
    </message>
    <message>
        <source>No end: the registration did not settle. Retry with a wider search.</source>
        <translation>未収束: 位置合わせが定まらなかった。より広い探索で再試行する。</translation>
    </message>
    <message>
        <source>no odometry</source>
        <translation>オドメトリなし</translation>
    </message>
    <message>
        <source>No odometry: nobody knows how the robot came there. Retry from a pose that you drag.</source>
        <translation>オドメトリなし: ロボットがどう移動したか不明。位置を指定して再試行する。</translation>
    </message>
    <message>
        <source>too few points</source>
        <translation>点不足</translation>
    </message>
    <message>
        <source>Too few points: reject it, the next scan says more.</source>
        <translation>点不足: 除外する。次のスキャンで情報が増える。</translation>
    </message>
    <message>
        <source>certain</source>
        <translation>確実</translation>
    </message>
    <message>
        <source>uncertain ?</source>
        <translation>不確実 ?</translation>
    </message>
    <message>
        <source>set aside</source>
        <translation>除外</translation>
    </message>
    <message>
        <source>motion partly guessed</source>
        <translation>動きの一部が推定</translation>
    </message>
    <message>
        <source>Motion partly guessed: odometry was missing or late within the scan. Look whether its walls are bent.</source>
        <translation>動きの一部が推定: スキャン中のオドメトリが欠けたか遅れました。壁が曲がっていないか確かめてください。</translation>
    </message>
</context>
<context>
    <name>leitstand::ScanFeature</name>
    <message>
        <source>&amp;Laser in the virtual scan</source>
        <translation>仮想スキャンにレーザーを表示(&amp;L)</translation>
    </message>
    <message>
        <source>Draws what plane lasers measured, as it came, over the contours of walls and obstacles</source>
        <translation>平面レーザーの測定値をそのまま、壁と障害物の輪郭に重ねて描きます</translation>
    </message>
</context>
<context>
    <name>leitstand::ScanListModel</name>
    <message>
        <source>%1 of them used after range limits, filter and voxels</source>
        <translation>距離範囲・フィルタ・ボクセル適用後に %1 点を使用</translation>
    </message>
    <message>
        <source>Scan</source>
        <translation>スキャン</translation>
    </message>
    <message>
        <source>x y z m</source>
        <translation>x y z m</translation>
    </message>
    <message>
        <source>Heading</source>
        <translation>方位</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>点数</translation>
    </message>
    <message>
        <source>Floor</source>
        <translation>床</translation>
    </message>
    <message>
        <source>Wall</source>
        <translation>壁</translation>
    </message>
    <message>
        <source>Ceiling</source>
        <translation>天井</translation>
    </message>
    <message>
        <source>Steps</source>
        <translation>反復</translation>
    </message>
    <message>
        <source>RMS mm</source>
        <translation>RMS mm</translation>
    </message>
    <message>
        <source>Overlap</source>
        <translation>重なり</translation>
    </message>
    <message>
        <source>Certainty</source>
        <translation>確実度</translation>
    </message>
    <message>
        <source>Name of the scan; the box shows or hides it</source>
        <translation>スキャンの名前。チェックで表示/非表示</translation>
    </message>
    <message>
        <source>Position in the map: metres forward, left and up of the first scan</source>
        <translation>地図上の位置: 最初のスキャンから前・左・上へのメートル</translation>
    </message>
    <message>
        <source>Heading in the map, to the left of the first scan&apos;s</source>
        <translation>地図上の方位: 最初のスキャンの方位から左回り</translation>
    </message>
    <message>
        <source>Points of the scan</source>
        <translation>スキャンの点</translation>
    </message>
    <message>
        <source>Share of the labelled points that is floor</source>
        <translation>ラベル付きの点に占める床の割合</translation>
    </message>
    <message>
        <source>Share of the labelled points that is wall</source>
        <translation>ラベル付きの点に占める壁の割合</translation>
    </message>
    <message>
        <source>Share of the labelled points that is ceiling</source>
        <translation>ラベル付きの点に占める天井の割合</translation>
    </message>
    <message>
        <source>Iterations of the ICP, over all stages</source>
        <translation>ICP の反復数（全段階）</translation>
    </message>
    <message>
        <source>Root mean square distance of the point pairs at the end, in millimetres. Says little about the pose: overlap and certainty say more.</source>
        <translation>終了時の点対距離の二乗平均平方根 (mm)。位置姿勢の良否はあまり示さない: 重なりと確実度の方が有用。</translation>
    </message>
    <message>
        <source>Share of the scan&apos;s points with a partner within 10 cm</source>
        <translation>10 cm 以内に対応点があるスキャンの点の割合</translation>
    </message>
    <message>
        <source>Whether the pose is held in every direction, from the smallest eigenvalue of the information matrix</source>
        <translation>位置姿勢が全方向に拘束されているか。情報行列の最小固有値による</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>位置</translation>
    </message>
    <message>
        <source>  m</source>
        <translation>  m</translation>
    </message>
    <message>
        <source>Roll pitch heading</source>
        <translation>ロール ピッチ 方位</translation>
    </message>
    <message>
        <source>%1, used %2</source>
        <translation>%1、使用 %2</translation>
    </message>
    <message>
        <source>Labels</source>
        <translation>ラベル</translation>
    </message>
    <message>
        <source>floor</source>
        <translation>床</translation>
    </message>
    <message>
        <source>wall</source>
        <translation>壁</translation>
    </message>
    <message>
        <source>ceiling</source>
        <translation>天井</translation>
    </message>
    <message>
        <source>Corrected by</source>
        <translation>補正量</translation>
    </message>
    <message>
        <source>%1 m, %2</source>
        <translation>%1 m、%2</translation>
    </message>
    <message>
        <source>Registration</source>
        <translation>位置合わせ</translation>
    </message>
    <message>
        <source>%1 steps in %2 s, RMS %3 mm</source>
        <translation>反復 %1、%2 s、RMS %3 mm</translation>
    </message>
    <message>
        <source>Trust</source>
        <translation>信頼性</translation>
    </message>
</context>
<context>
    <name>leitstand::ScannerFeature</name>
    <message>
        <source>Co&amp;rrect the scanner as the map says</source>
        <translation>地図のとおりにスキャナーを補正(&amp;R)</translation>
    </message>
    <message>
        <source>Leave the sca&amp;nner as it is</source>
        <translation>スキャナーをそのままにする(&amp;N)</translation>
    </message>
    <message>
        <source>Correct</source>
        <translation>補正する</translation>
    </message>
    <message>
        <source>Leave</source>
        <translation>そのまま</translation>
    </message>
    <message>
        <source>The map finds no scanner to be off</source>
        <translation>地図から見て、ずれているスキャナーはありません</translation>
    </message>
    <message>
        <source>From its next scan on, and in the robot&apos;s file: also when it is connected next time. What is in the map stays</source>
        <translation>次のスキャンから補正し、ロボットのファイルにも書きます。次に接続するときも有効です。地図にあるものは変わりません</translation>
    </message>
    <message>
        <source>Nothing changes, and it is not asked about again</source>
        <translation>何も変わらず、再び尋ねることもありません</translation>
    </message>
    <message>
        <source>%1: its 3D scanner measures %2 too far. Correct that?</source>
        <translation>%1: 3Dスキャナーの測定値が %2 長すぎます。補正しますか？</translation>
    </message>
    <message>
        <source>%1: its 3D scanner measures %2 too short. Correct that?</source>
        <translation>%1: 3Dスキャナーの測定値が %2 短すぎます。補正しますか？</translation>
    </message>
    <message>
        <source>%1: its 3D scanner leans, %2 to the %3 and %4 %5, against where it is said to sit. Correct that?</source>
        <translation>%1: 3Dスキャナーが、取り付けの記載に対して%3に %2、%5に %4 傾いています。補正しますか？</translation>
    </message>
    <message>
        <source>right</source>
        <translation>右</translation>
    </message>
    <message>
        <source>left</source>
        <translation>左</translation>
    </message>
    <message>
        <source>ahead</source>
        <translation>前</translation>
    </message>
    <message>
        <source>back</source>
        <translation>後ろ</translation>
    </message>
    <message>
        <source>%1 farther ahead</source>
        <translation>%1 前方</translation>
    </message>
    <message>
        <source>%1 farther back</source>
        <translation>%1 後方</translation>
    </message>
    <message>
        <source>%1 farther left</source>
        <translation>%1 左</translation>
    </message>
    <message>
        <source>%1 farther right</source>
        <translation>%1 右</translation>
    </message>
    <message>
        <source>turned %1 to the left</source>
        <translation>左に %1 回転</translation>
    </message>
    <message>
        <source>turned %1 to the right</source>
        <translation>右に %1 回転</translation>
    </message>
    <message>
        <source>%1: the clock of its 3D scanner is %2 ahead of its odometry&apos;s. Correct that?</source>
        <translation>%1: 3Dスキャナーの時計がオドメトリより %2 進んでいます。補正しますか？</translation>
    </message>
    <message>
        <source>%1: the clock of its 3D scanner is %2 behind its odometry&apos;s. Correct that?</source>
        <translation>%1: 3Dスキャナーの時計がオドメトリより %2 遅れています。補正しますか？</translation>
    </message>
    <message>
        <source>%1: its 3D scanner is not mounted as described, but %2. Correct that?</source>
        <translation>%1: 3Dスキャナーの取り付けが記述と異なります（%2）。補正しますか？</translation>
    </message>
</context>
<context>
    <name>leitstand::ScansPanel</name>
    <message>
        <source>Scans of the map</source>
        <translation>地図のスキャン</translation>
    </message>
    <message>
        <source>Show all scans</source>
        <translation>全スキャンを表示</translation>
    </message>
    <message>
        <source>Hide all scans</source>
        <translation>全スキャンを非表示</translation>
    </message>
</context>
<context>
    <name>leitstand::ScorePane</name>
    <message>
        <source>More would bring</source>
        <translation>加点できる項目</translation>
    </message>
    <message>
        <source>Estimate of the score</source>
        <translation>得点の見積もり</translation>
    </message>
    <message>
        <source>An estimate: judges look at the map, which counts as good here</source>
        <translation>見積もり: 地図は審判が評価する。ここでは良好とみなす</translation>
    </message>
    <message>
        <source>What each find adds, and what would bring more</source>
        <translation>各発見物の点数と、さらに点になるもの</translation>
    </message>
    <message>
        <source>Nothing to score yet: what a find brings is listed here</source>
        <translation>まだ採点対象がありません。発見ごとの得点がここに表示されます</translation>
    </message>
</context>
<context>
    <name>leitstand::ScoreText</name>
    <message>
        <source>map</source>
        <translation>地図</translation>
    </message>
    <message>
        <source>place</source>
        <translation>位置</translation>
    </message>
    <message>
        <source>form</source>
        <translation>形状</translation>
    </message>
    <message>
        <source>motion</source>
        <translation>動き</translation>
    </message>
    <message>
        <source>heat</source>
        <translation>熱</translation>
    </message>
    <message>
        <source>sound</source>
        <translation>音</translation>
    </message>
    <message>
        <source>CO₂</source>
        <translation>CO₂</translation>
    </message>
    <message>
        <source>situation</source>
        <translation>状況</translation>
    </message>
    <message>
        <source>tag</source>
        <translation>タグ</translation>
    </message>
    <message>
        <source>%1, not confirmed</source>
        <translation>%1 (未確認)</translation>
    </message>
    <message>
        <source> · area × %1</source>
        <translation> · エリア × %1</translation>
    </message>
    <message>
        <source> · autonomy × %1</source>
        <translation> · 自律 × %1</translation>
    </message>
    <message>
        <source>%1 points</source>
        <translation>%1 点</translation>
    </message>
    <message>
        <source>%1 · version %2</source>
        <translation>%1 · バージョン %2</translation>
    </message>
    <message>
        <source> · %1 values unconfirmed</source>
        <translation> · 未確定の値 %1 個</translation>
    </message>
    <message>
        <source>%1 min left</source>
        <translation>残り %1 分</translation>
    </message>
    <message>
        <source>time is over</source>
        <translation>時間切れ</translation>
    </message>
    <message>
        <source>%1 × touched the arena</source>
        <translation>アリーナ接触 × %1</translation>
    </message>
    <message>
        <source>%1 × touched a victim</source>
        <translation>被災者接触 × %1</translation>
    </message>
    <message>
        <source>operators: %1</source>
        <translation>操縦者: %1</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <comment>V1: heat</comment>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>%1: confirm</source>
        <translation>%1: 確認する</translation>
    </message>
    <message>
        <source>area “%1” has no weight in these rules</source>
        <translation>エリア「%1」はこの規則では重みなし</translation>
    </message>
</context>
<context>
    <name>leitstand::ScreenWords</name>
    <message>
        <source>somebody sends what is no RTPS: {0} from {1}</source>
        <translation>RTPS ではないものが送られています: {1} から {0}</translation>
    </message>
    <message>
        <source>somebody sends numbers that no writer can have reached: {0} from {1}</source>
        <translation>どの送信元も達しえない番号が送られています: {1} から {0}</translation>
    </message>
    <message>
        <source>somebody speaks in the name of another participant: {0} from {1}</source>
        <translation>ほかの参加者の名をかたる送信があります: {1} から {0}</translation>
    </message>
    <message>
        <source>more participants or endpoints than a computer may have are refused: {0} from {1}</source>
        <translation>1 台の計算機に許される数を超える参加者またはエンドポイントを拒否しています: {1} から {0}</translation>
    </message>
    <message>
        <source>somebody who is no participant sends too much: {0} from {1}</source>
        <translation>参加者でないものからの送信が多すぎます: {1} から {0}</translation>
    </message>
    <message>
        <source>somebody without keys sends what is not encrypted: {0} from {1}</source>
        <translation>鍵のないものから暗号化されていない送信があります: {1} から {0}</translation>
    </message>
    <message>
        <source>one packet</source>
        <translation>1 パケット</translation>
    </message>
    <message>
        <source>{0} packets</source>
        <translation>{0} パケット</translation>
    </message>
    <message>
        <source>,</source>
        <translation>,</translation>
    </message>
    <message>
        <source>many addresses</source>
        <translation>多数のアドレス</translation>
    </message>
    <message>
        <source>what comes by shared memory is not screened: a program of this computer can bring this one to a halt (the profile file asks for it)</source>
        <translation>共有メモリ経由のデータは検査されません: この計算機の別のプログラムがこのプログラムを止めることができます（プロファイルファイルの指定による）</translation>
    </message>
    <message>
        <source>what comes by TCP is not screened: who can connect can bring this program to a halt (the profile file asks for it)</source>
        <translation>TCP 経由のデータは検査されません: 接続できる者はこのプログラムを止めることができます（プロファイルファイルの指定による）</translation>
    </message>
</context>
<context>
    <name>leitstand::ServiceMenu</name>
    <message>
        <source>Se&amp;rvices</source>
        <translation>サービス(&amp;R)</translation>
    </message>
    <message>
        <source>%1: on</source>
        <comment>a service that switches something</comment>
        <translation>%1：オン</translation>
    </message>
    <message>
        <source>%1: off</source>
        <comment>a service that switches something</comment>
        <translation>%1：オフ</translation>
    </message>
    <message>
        <source>%1 has none</source>
        <translation>%1 にはありません</translation>
    </message>
    <message>
        <source>Calls %1</source>
        <translation>%1 を呼び出します</translation>
    </message>
    <message>
        <source>Nobody offers %1 now</source>
        <translation>%1 を提供するノードが今はありません</translation>
    </message>
</context>
<context>
    <name>leitstand::SightLine</name>
    <message>
        <source>the picture is %1 old</source>
        <translation>映像が %1 前のもの</translation>
    </message>
    <message>
        <source>there is no picture</source>
        <translation>映像がない</translation>
    </message>
    <message>
        <source>it is the same picture for %1</source>
        <translation>%1 同じ映像のまま</translation>
    </message>
    <message>
        <source>the scan of the way is %1 old</source>
        <translation>進路のスキャンが %1 前のもの</translation>
    </message>
    <message>
        <source>there is no scan of the way</source>
        <translation>進路のスキャンがない</translation>
    </message>
    <message>
        <source>no camera, no scanner: you must see it</source>
        <translation>カメラもスキャナもない: 目視が必要</translation>
    </message>
    <message>
        <source>override: driving without eyes · %1</source>
        <translation>オーバーライド: 視界なし走行 · %1</translation>
    </message>
    <message>
        <source>override held: nothing caps the speed</source>
        <translation>オーバーライド中: 速度制限なし</translation>
    </message>
    <message>
        <source>%1: drive by the virtual scan</source>
        <translation>%1: 仮想スキャンで操縦</translation>
    </message>
    <message>
        <source>creep speed: %1</source>
        <translation>微速: %1</translation>
    </message>
    <message>
        <source>held: %1 · hold G to drive without eyes</source>
        <translation>抑止: %1 · G を押し続けると視界なし走行</translation>
    </message>
    <message>
        <source>override: driving without eyes</source>
        <translation>オーバーライド: 視界なし走行</translation>
    </message>
    <message>
        <source>override</source>
        <translation>オーバーライド</translation>
    </message>
    <message>
        <source>held</source>
        <translation>抑止</translation>
    </message>
    <message>
        <source>creep speed</source>
        <translation>微速</translation>
    </message>
    <message>
        <source>full speed</source>
        <translation>全速</translation>
    </message>
</context>
<context>
    <name>leitstand::Station</name>
    <message>
        <source>{} has no guard and is not driven: {}</source>
        <translation>{}: ガードがないため操縦しません: {}</translation>
    </message>
    <message>
        <source>{} is not in the map yet: nothing was filed</source>
        <translation>{} がまだ地図にない: 登録なし</translation>
    </message>
    <message>
        <source>no range there: filed ahead of the robot; move it on the map</source>
        <translation>その方向に距離なし: ロボットの前方に登録。地図上で移動</translation>
    </message>
    <message>
        <source>{} has new evidence: press again to confirm</source>
        <translation>{} に証拠を追加: もう一度押すと確定</translation>
    </message>
    <message>
        <source>{} filed: press again to confirm</source>
        <translation>{} を登録: もう一度押すと確定</translation>
    </message>
    <message>
        <source>there is nothing on finds to take back</source>
        <translation>発見に取り消せる操作なし</translation>
    </message>
    <message>
        <source>Snapshot kept: {}</source>
        <translation>スナップショットを保存: {}</translation>
    </message>
    <message>
        <source>its laser fits the map again</source>
        <translation>レーザーが再び地図と一致</translation>
    </message>
    <message>
        <source>its place in the map is doubted</source>
        <translation>地図内の位置が疑わしい</translation>
    </message>
    <message>
        <source>found in the map</source>
        <translation>地図内で発見</translation>
    </message>
    <message>
        <source>not found beside the other robot: put it to where it stands, or let the other one see it</source>
        <translation>もう一方のロボットの横に見つからない: 実際の位置に置くか、もう一方に見せる</translation>
    </message>
    <message>
        <source>not found there</source>
        <translation>そこには見つからない</translation>
    </message>
    <message>
        <source>the map is another station&apos;s: ask it for the map, or wait until it is silent</source>
        <translation>地図は別の局が管理中: 譲渡を求めるか、応答がなくなるまで待つ</translation>
    </message>
    <message>
        <source>rewind: no scan entered the map after that moment</source>
        <translation>巻き戻し: その時点以降に地図へ入ったスキャンなし</translation>
    </message>
    <message>
        <source>nothing to be taken back: no decision on the map stands</source>
        <translation>取り消すものなし: 地図に関する有効な操作なし</translation>
    </message>
    <message>
        <source>nothing to be done again: nothing was taken back last</source>
        <translation>やり直すものなし: 直前の取り消しなし</translation>
    </message>
    <message>
        <source>there is no map yet to put a robot into</source>
        <translation>ロボットを置く地図がまだない</translation>
    </message>
    <message>
        <source>{}: there are no key scans that could be registered again</source>
        <translation>{}: 再登録できるキースキャンがない</translation>
    </message>
    <message>
        <source>Cameras looked from more places than can be kept: what they look at from now on may not count as searched</source>
        <translation>カメラの視点が保存できる数を超えた: 今後見る場所は探索済みに数えられないことがある</translation>
    </message>
    <message>
        <source>This computer is too slow for all that cameras look at: some of it does not count as searched</source>
        <translation>この計算機はカメラが見る全てには遅すぎる: 一部は探索済みに数えられない</translation>
    </message>
    <message>
        <source>{}: the mission has no such find to change so</source>
        <translation>{}: ミッションに該当する発見がない</translation>
    </message>
    <message>
        <source>the mission has no such candidate</source>
        <translation>ミッションに該当する候補がない</translation>
    </message>
    <message>
        <source>a note without words is none</source>
        <translation>空のメモは記録できない</translation>
    </message>
    <message>
        <source>{}: the mission has no {}</source>
        <translation>{}: ミッションに {} がない</translation>
    </message>
    <message>
        <source>its laser sees too little: {} points</source>
        <translation>レーザの点が少なすぎる: {} 点</translation>
    </message>
    <message>
        <source>its laser sees too little</source>
        <translation>レーザの点が少なすぎる</translation>
    </message>
    <message>
        <source>too little of what it sees is in the map</source>
        <translation>観測の大部分が地図にない</translation>
    </message>
    <message>
        <source>only {} % of what it sees is in the map</source>
        <translation>観測の {} % しか地図にない</translation>
    </message>
    <message>
        <source>{} % of what it sees is in the map</source>
        <translation>観測の {} % が地図と一致</translation>
    </message>
    <message>
        <source>{} % of what its laser sees is in the map</source>
        <translation>レーザ観測の {} % が地図と一致</translation>
    </message>
    <message>
        <source>{}: {}</source>
        <translation>{}: {}</translation>
    </message>
    <message>
        <source>{} % of what it sees is in the map, {} cm and {} degrees from the guess</source>
        <translation>観測の {} % が地図と一致、推定との差 {} cm・{} 度</translation>
    </message>
    <message>
        <source>the walls leave a direction open</source>
        <translation>壁では一方向が定まらない</translation>
    </message>
    <message>
        <source>it could as well stand elsewhere</source>
        <translation>別の場所の可能性もある</translation>
    </message>
    <message>
        <source>its laser fits {} cm from where its tracks say</source>
        <translation>レーザの位置が履帯の推定から {} cm ずれている</translation>
    </message>
    <message>
        <source>found again: {}</source>
        <translation>再発見: {}</translation>
    </message>
    <message>
        <source>{} sees it: {} % of what its laser sees there is in the map</source>
        <translation>{} から見える: レーザ観測の {} % が地図と一致</translation>
    </message>
    <message>
        <source>it would see things where the map has none</source>
        <translation>地図にない物が見えることになる</translation>
    </message>
    <message>
        <source>put there by the operator; its laser says nothing</source>
        <translation>オペレータが配置、レーザでは確認できない</translation>
    </message>
    <message>
        <source>put there by the operator; its next scan tells where it stands</source>
        <translation>オペレータが配置、次のスキャンで位置が決まる</translation>
    </message>
    <message>
        <source>its scan fits the map</source>
        <translation>スキャンが地図と一致</translation>
    </message>
    <message>
        <source>its scan does not fit</source>
        <translation>スキャンが地図と合わない</translation>
    </message>
    <message>
        <source>its newest key scan</source>
        <translation>最新のキースキャン</translation>
    </message>
    <message>
        <source>put there by the operator, but {}</source>
        <translation>オペレータが配置したが {}</translation>
    </message>
    <message>
        <source>where it was when the station was left: {}</source>
        <translation>ステーション終了時の位置: {}</translation>
    </message>
    <message>
        <source>where it was when the station was left</source>
        <translation>ステーション終了時の位置</translation>
    </message>
    <message>
        <source>its odometry began anew</source>
        <translation>オドメトリが初期化された</translation>
    </message>
    <message>
        <source>no station made a map of this mission: {} of its {} scans were registered for the review, without anyone&apos;s check</source>
        <translation>このミッションの地図はどのステーションも作成していません: {} / {} スキャンを閲覧用に位置合わせしました（誰も確認していません）</translation>
    </message>
    <message>
        <source>{}: no station of ours recorded it, so that it stays as it is; nothing can be written into it</source>
        <translation>{}: Leitstand のステーションの記録ではないため、そのまま残します。書き込みはできません</translation>
    </message>
    <message>
        <source>key scan {}: expected one of the map</source>
        <translation>キースキャン {}：地図にあるものを指定してください</translation>
    </message>
    <message>
        <source>&quot;{}&quot; is none of the station&apos;s robots</source>
        <translation>「{}」はこのステーションのロボットではありません</translation>
    </message>
    <message>
        <source>{}: its file names no stream_command stream</source>
        <translation>{}：設定ファイルに stream_command ストリームがありません</translation>
    </message>
    <message>
        <source>{}: {} is none of the streams that it sends</source>
        <translation>{}：{} は送信されるストリームではありません</translation>
    </message>
    <message>
        <source>Nothing is filed that could be confirmed: F files what the robot sees</source>
        <translation>確定できる登録がない: F でロボットが見ているものを登録</translation>
    </message>
    <message>
        <source>nothing was scanned there: point to it on the map</source>
        <translation>そこは未スキャン: 地図上でクリックして指定</translation>
    </message>
    <message>
        <source>the robot was not in the map then: nothing was filed</source>
        <translation>その時点でロボットは地図上になかったため、登録していない</translation>
    </message>
    <message>
        <source>another station makes another map than this mission&apos;s (their scans {} differ): it is not shown here; begin a new mission to see it</source>
        <translation>別のステーションがこのミッションとは異なる地図を作成しています(スキャン {} が一致しません):ここには表示されません。見るには新しいミッションを開始してください</translation>
    </message>
    <message>
        <source>{} of another station was found first: this station&apos;s {} is {} now</source>
        <translation>別のステーションの {} が先に発見されました:このステーションの {} は {} になりました</translation>
    </message>
    <message>
        <source>nothing was written in reviews that could be taken back</source>
        <translation>レビューで取り消せる記録がない</translation>
    </message>
    <message>
        <source>{} is sent nowhere during its brake test</source>
        <translation>{} はブレーキテスト中のため目標へ送れない</translation>
    </message>
    <message>
        <source>{} failed its brake test: it is sent nowhere until it passes or is driven nevertheless</source>
        <translation>{} はブレーキテストに不合格: 合格するか、それでも操縦すると決めるまで目標へ送れない</translation>
    </message>
    <message>
        <source>{} has new evidence; it is confirmed already</source>
        <translation>{} に証拠を追加 (すでに確定済み)</translation>
    </message>
    <message>
        <source>the mission&apos;s log does not answer: it is not known whether this was written</source>
        <translation>ミッションの記録が応答しません: 書き込まれたかどうか分かりません</translation>
    </message>
    <message>
        <source>a closed loop contradicts the rest of the map: it does not count any more</source>
        <translation>閉じたループが地図の他の部分と矛盾しています。今後は数えません</translation>
    </message>
    <message>
        <source>the map meets itself: its parts moved by up to {} m</source>
        <translation>地図がつながりました。各部が最大 {} m 動きました</translation>
    </message>
    <message>
        <source>nothing to be taken back: no loop closed</source>
        <translation>取り消すものがありません。閉じたループはありません</translation>
    </message>
    <message>
        <source>is this a place that was seen before? The map is farther off here than expected: say whether it is the same place</source>
        <translation>ここは前に見た場所ですか。地図のずれが予想より大きいので、同じ場所かどうかを答えてください</translation>
    </message>
    <message>
        <source>nothing is asked about the map</source>
        <translation>地図についての質問はありません</translation>
    </message>
    <message>
        <source>{}: expected a map of ours, found no key scans</source>
        <translation>{}: 本ソフトの地図が必要ですが、キースキャンがありません</translation>
    </message>
    <message>
        <source>cancelled: the map is as it was</source>
        <translation>中止しました: 地図は元のままです</translation>
    </message>
    <message>
        <source>{}: its map was not tidied</source>
        <translation>{}: 地図は整えられていません</translation>
    </message>
    <message>
        <source>{}: expected the mission&apos;s folder</source>
        <translation>{}: ミッションのフォルダが必要です</translation>
    </message>
    <message>
        <source>{}: somebody wrote into it meanwhile; try again</source>
        <translation>{}: その間に書き込みがありました。もう一度実行してください</translation>
    </message>
    <message>
        <source>{}: the tidied map went on since; it stays</source>
        <translation>{}: 整えた地図はその後変わったため、そのままです</translation>
    </message>
    <message>
        <source>{} places of the map look like where it is: put it to where it stands</source>
        <translation>地図の {} か所が似ています: 実際の位置に置いてください</translation>
    </message>
    <message>
        <source>no place of the map fits its newest 3D scan for sure: put it to where it stands</source>
        <translation>最新の 3D スキャンが確実に合う場所が地図にありません: 実際の位置に置いてください</translation>
    </message>
    <message>
        <source>found in the whole map, where {} % of what it sees fits; its next scan tells whether it stands there</source>
        <translation>地図全体から発見。見えているものの {} % が合います。次のスキャンで確認します</translation>
    </message>
    <message>
        <source>scan {}: expected one that counts: accept it first</source>
        <translation>スキャン {}: 有効なスキャンが必要です。先に採用してください</translation>
    </message>
    <message>
        <source>scan {} does not fit there: draw it nearer to where it was, or it is another place</source>
        <translation>スキャン {} はそこに合いません。実際の場所のもっと近くに描いてください。あるいは別の場所です</translation>
    </message>
    <message>
        <source>scan {}: no older part of the map is within {} m of there</source>
        <translation>スキャン {}: そこから {} m 以内に地図の古い部分はありません</translation>
    </message>
    <message>
        <source>the map is tidy: nothing moved, nothing was written</source>
        <translation>地図は整っています。何も動かず、何も書き込まれませんでした</translation>
    </message>
    <message>
        <source>the map is tidied: {} of {} scans moved, by up to {} m</source>
        <translation>地図を整えました。{} / {} 個のスキャンが最大 {} m 動きました</translation>
    </message>
    <message>
        <source>; {} links of loops contradict the rest and do not count any more</source>
        <translation>。ループの結合 {} 個は残りと矛盾するため無効になりました</translation>
    </message>
    <message>
        <source>the map asks about another place by now: look at it again</source>
        <translation>地図は今、別の場所について尋ねています。もう一度見てください</translation>
    </message>
    <message>
        <source>the map is as it was before it was tidied</source>
        <translation>地図は整える前の状態に戻りました</translation>
    </message>
    <message>
        <source>{}: what its 3D scanner measures does not fit together: say whether it is to be corrected</source>
        <translation>{}: 3Dスキャナーの測定値が互いに合いません。補正するかどうか答えてください</translation>
    </message>
    <message>
        <source>{}: its 3D scanner is corrected from its next scan on</source>
        <translation>{}: 3Dスキャナーを次のスキャンから補正します</translation>
    </message>
    <message>
        <source>, and from now on by its file {}</source>
        <translation>。今後はファイル {} でも補正します</translation>
    </message>
    <message>
        <source>nothing is asked about the scanner any more</source>
        <translation>スキャナーについての質問はもうありません</translation>
    </message>
    <message>
        <source>two parts of the map seem to have seen the same place: say whether they did</source>
        <translation>地図の2つの部分が同じ場所を見たようです。同じかどうか答えてください</translation>
    </message>
    <message>
        <source>cancelled</source>
        <translation>中止しました</translation>
    </message>
    <message>
        <source>it maps a part of its own, which has not met the rest yet</source>
        <translation>独自の部分を作成中で、まだ残りの地図と結合していません</translation>
    </message>
    <message>
        <source>{}: it is there already: a map is carried into a new mission</source>
        <translation>{}: すでに存在します。地図は新しいミッションにのみ引き継げます</translation>
    </message>
    <message>
        <source>{}: a map is merged with that of another mission</source>
        <translation>{}: 地図は別のミッションの地図と統合します</translation>
    </message>
    <message>
        <source>the map is tidy: nothing moved; its scans are held together by {} links now</source>
        <translation>地図は整っています。動いたものはなく、スキャンは {} 本のリンクで結ばれました</translation>
    </message>
    <message>
        <source>it does not fit the rest of the map there: move it nearer to where it belongs, or snap it first</source>
        <translation>そこでは地図の残りと合いません。正しい場所に近づけるか、先に吸着させてください</translation>
    </message>
    <message>
        <source>{}: nothing tells how its scans hang together: tidy the map first</source>
        <translation>{}: スキャン同士のつながりが記録されていません。先に地図を整えてください</translation>
    </message>
    <message>
        <source>{}: its map is made from {}; its other clouds are shown, and used for obstacles</source>
        <translation>{}: 地図は {} から作られます。他の点群は表示され、障害物に使われます</translation>
    </message>
    <message>
        <source>{}: its plane laser {} makes the map</source>
        <translation>{}: 平面レーザー {} で地図を作成します</translation>
    </message>
    <message>
        <source>{}: expected a topic of its scanners, found {}</source>
        <translation>{}: スキャナーのトピックが必要ですが、{} です</translation>
    </message>
    <message>
        <source>{} is stopped: it is sent nowhere before its release</source>
        <translation>{} は停止中です：解除するまでどこへも送れません</translation>
    </message>
    <message>
        <source>{} on</source>
        <translation>{} オン</translation>
    </message>
    <message>
        <source>{} off</source>
        <translation>{} オフ</translation>
    </message>
    <message>
        <source>{}: no answer</source>
        <translation>{}：応答なし</translation>
    </message>
    <message>
        <source>{}: done</source>
        <translation>{}：完了</translation>
    </message>
    <message>
        <source>{}: done ({})</source>
        <translation>{}：完了（{}）</translation>
    </message>
    <message>
        <source>{}: refused</source>
        <translation>{}：拒否</translation>
    </message>
    <message>
        <source>{}: refused ({})</source>
        <translation>{}：拒否（{}）</translation>
    </message>
    <message>
        <source>{}: another station has its drive control</source>
        <translation>{}：操縦権は別の操作卓にあります</translation>
    </message>
</context>
<context>
    <name>leitstand::StickGauge</name>
    <message>
        <source>Tick: the stick as it is held; shade: dead zone; bar: what comes of it</source>
        <translation>目印: 現在のスティック。網掛け: 不感帯。バー: 出力</translation>
    </message>
    <message>
        <source>%1 and opposite</source>
        <translation>%1 と逆方向</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
</context>
<context>
    <name>leitstand::StopButton</name>
    <message>
        <source>STOP ALL</source>
        <translation>全機 STOP</translation>
    </message>
    <message>
        <source>Esc</source>
        <translation>Esc</translation>
    </message>
    <message>
        <source>Stop all robots</source>
        <translation>全ロボットを停止</translation>
    </message>
    <message>
        <source>Stops all robots and holds them until each is released (Esc, always and everywhere).
A function of this program, no certified emergency stop.</source>
        <translation>全ロボットを停止し、個別に解除するまで保持する（Esc、常にどこでも有効）。
本プログラムの機能であり、認証された非常停止ではない。</translation>
    </message>
</context>
<context>
    <name>leitstand::StopLine</name>
    <message>
        <source>held by zeros</source>
        <translation>ゼロ指令で保持</translation>
    </message>
    <message>
        <source>sent</source>
        <translation>送信済み</translation>
    </message>
    <message>
        <source>sent · no answer for %1</source>
        <translation>送信済み · %1 返答なし</translation>
    </message>
    <message>
        <source>confirmed · moves</source>
        <translation>受領 · 動作中</translation>
    </message>
    <message>
        <source>confirmed · motion unknown</source>
        <translation>受領 · 動作不明</translation>
    </message>
    <message>
        <source>standing</source>
        <translation>静止</translation>
    </message>
    <message>
        <source>releasing</source>
        <translation>解除中</translation>
    </message>
    <message>
        <source>The release did nothing: %1</source>
        <translation>解除できなかった: %1</translation>
    </message>
    <message>
        <source>The robot knows no stops: it is held by drive commands of zero.</source>
        <translation>ロボットに停止機能がない: ゼロの走行指令で保持している。</translation>
    </message>
    <message>
        <source>Stopped by the robot&apos;s own button.</source>
        <translation>ロボット本体のボタンで停止。</translation>
    </message>
    <message>
        <source>Stopped by another station.</source>
        <translation>別の操作卓が停止。</translation>
    </message>
    <message>
        <source>Only the station with drive control can release it.</source>
        <translation>解除できるのは操縦権の保持者のみ。</translation>
    </message>
    <message>
        <source>? %1</source>
        <comment>a stop, not answered for 4.2 s</comment>
        <translation>? %1</translation>
    </message>
    <message>
        <source>&gt; 1 h</source>
        <translation>&gt; 1 h</translation>
    </message>
    <message>
        <source>held</source>
        <comment>by zeros</comment>
        <translation>保持</translation>
    </message>
    <message>
        <source>sent</source>
        <comment>where there is little room</comment>
        <translation>送信</translation>
    </message>
    <message>
        <source>moves</source>
        <translation>動作中</translation>
    </message>
    <message>
        <source>moves?</source>
        <translation>動作?</translation>
    </message>
    <message>
        <source>stands</source>
        <translation>静止</translation>
    </message>
    <message>
        <source>release</source>
        <comment>is on its way</comment>
        <translation>解除中</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>The robot knows no stops: it is held by drive commands of zero and by its lock.</source>
        <translation>このロボットは停止指令を解しません：ゼロの走行指令とロックで停止を保ちます。</translation>
    </message>
    <message>
        <source>The robot knows no stops: it is held by drive commands of zero. Nobody listens to its lock.</source>
        <translation>このロボットは停止指令を解しません：ゼロの走行指令で停止を保ちます。ロックを受信する相手がいません。</translation>
    </message>
    <message>
        <source>%1 refuses.</source>
        <translation>%1 が拒否しています。</translation>
    </message>
    <message>
        <source>%1 refuses: %2.</source>
        <comment>a service, its own words</comment>
        <translation>%1 が拒否しています：%2。</translation>
    </message>
    <message>
        <source>%1 has not confirmed yet.</source>
        <translation>%1 はまだ確認していません。</translation>
    </message>
    <message>
        <source>Nobody offers %1.</source>
        <translation>%1 を提供するノードがありません。</translation>
    </message>
    <message>
        <source>%1 has not released yet.</source>
        <translation>%1 はまだ解除していません。</translation>
    </message>
    <message>
        <source>%1 confirmed it.</source>
        <translation>%1 が確認しました。</translation>
    </message>
    <message>
        <source>%1 cannot be called: %2.</source>
        <comment>a service, why</comment>
        <translation>%1 を呼び出せません：%2。</translation>
    </message>
    <message>
        <source>%1 services confirmed it.</source>
        <translation>%1 個のサービスが確認しました。</translation>
    </message>
</context>
<context>
    <name>leitstand::StoreyRow</name>
    <message>
        <source>Storeys of the map</source>
        <translation>地図の階</translation>
    </message>
    <message>
        <source>Storey %1, its floor at %2 m</source>
        <translation>階 %1、床の高さ %2 m</translation>
    </message>
    <message>
        <source>All</source>
        <comment>storeys</comment>
        <translation>全部</translation>
    </message>
    <message>
        <source>All storeys</source>
        <translation>すべての階</translation>
    </message>
</context>
<context>
    <name>leitstand::StoreysFeature</name>
    <message>
        <source>What is above and below that storey is not shown</source>
        <translation>その階の上と下は表示されません</translation>
    </message>
    <message>
        <source>Store&amp;y above</source>
        <translation>上の階(&amp;Y)</translation>
    </message>
    <message>
        <source>Storey belo&amp;w</source>
        <translation>下の階(&amp;W)</translation>
    </message>
    <message>
        <source>The map has one storey only</source>
        <translation>地図には階が一つしかありません</translation>
    </message>
</context>
<context>
    <name>leitstand::StreamList</name>
    <message>
        <source>Streams of all robots</source>
        <translation>全ロボットのストリーム</translation>
    </message>
</context>
<context>
    <name>leitstand::StreamTable</name>
    <message>
        <source>Stream</source>
        <translation>ストリーム</translation>
    </message>
    <message>
        <source>Type</source>
        <translation>型</translation>
    </message>
    <message>
        <source>Rate Hz</source>
        <translation>頻度 Hz</translation>
    </message>
    <message>
        <source>kbit/s</source>
        <translation>kbit/s</translation>
    </message>
    <message>
        <source>Age</source>
        <translation>経過</translation>
    </message>
    <message>
        <source>Loss</source>
        <translation>欠落</translation>
    </message>
    <message>
        <source>Setting</source>
        <translation>設定</translation>
    </message>
    <message>
        <source>Samples a second as they come, and as the robot makes them</source>
        <translation>受信した毎秒サンプル数と、ロボットが生成する数</translation>
    </message>
    <message>
        <source>What the stream takes of the link, without what is sent again</source>
        <translation>ストリームの通信量（再送を除く）</translation>
    </message>
    <message>
        <source>Since the newest sample arrived</source>
        <translation>最新サンプルの到着からの時間</translation>
    </message>
    <message>
        <source>Samples of the last 10 s that never arrived</source>
        <translation>直近 10 s に届かなかったサンプル</translation>
    </message>
    <message>
        <source>What the station asks of the stream; nothing: as the robot likes</source>
        <translation>操作卓がストリームに求める設定。空欄: ロボット任せ</translation>
    </message>
    <message>
        <source>off</source>
        <translation>オフ</translation>
    </message>
    <message>
        <source>on change</source>
        <translation>変化時</translation>
    </message>
    <message>
        <source>%1 Hz</source>
        <translation>%1 Hz</translation>
    </message>
    <message>
        <source>quality %1</source>
        <translation>画質 %1</translation>
    </message>
    <message>
        <source>%1 px</source>
        <translation>%1 px</translation>
    </message>
    <message>
        <source>thin: %1</source>
        <translation>低帯域: %1</translation>
    </message>
    <message>
        <source> · not yet</source>
        <translation> · 未反映</translation>
    </message>
    <message>
        <source>%1 of %2 Mbit/s</source>
        <translation>%1 / %2 Mbit/s</translation>
    </message>
    <message>
        <source>%1 Mbit/s</source>
        <translation>%1 Mbit/s</translation>
    </message>
    <message>
        <source>%1 (map)</source>
        <translation>%1 (地図)</translation>
    </message>
</context>
<context>
    <name>leitstand::SubmapFeature</name>
    <message>
        <source>Move a part of the map by &amp;hand</source>
        <translation>地図の一部を手で動かす(&amp;H)</translation>
    </message>
    <message>
        <source>Move &amp;more of the map, or less</source>
        <translation>動かす範囲を変える(&amp;M)</translation>
    </message>
    <message>
        <source>&amp;Snap the moved part</source>
        <translation>動かした部分を吸着(&amp;S)</translation>
    </message>
    <message>
        <source>Lays the moved part onto the rest of the map, from where it is</source>
        <translation>動かした部分を、今の位置から地図の残りに重ねます</translation>
    </message>
    <message>
        <source>&amp;Leave the moved part there</source>
        <translation>動かした部分をそこに置く(&amp;L)</translation>
    </message>
    <message>
        <source>Its scans are linked with those that they lie on, and the map follows</source>
        <translation>そのスキャンを重なるスキャンと結び、地図がそれに従います</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>キャンセル</translation>
    </message>
    <message>
        <source>More</source>
        <translation>範囲</translation>
    </message>
    <message>
        <source>Snap</source>
        <translation>吸着</translation>
    </message>
    <message>
        <source>Leave there</source>
        <translation>そこに置く</translation>
    </message>
    <message>
        <source>There is no part of the map that could be moved against the rest</source>
        <translation>残りに対して動かせる部分が地図にありません</translation>
    </message>
    <message>
        <source>Drag: moves the violet part · Shift+drag: turns it · right button: not at all</source>
        <translation>ドラッグ: 紫の部分を動かす · Shift+ドラッグ: 回す · 右ボタン: やめる</translation>
    </message>
    <message>
        <source>No other part of the map could be moved against the rest</source>
        <translation>残りに対して動かせる部分はほかにありません</translation>
    </message>
    <message>
        <source>Too little of it lies on the rest of the map there: drag it nearer first</source>
        <translation>そこでは地図の残りとの重なりが少なすぎます。先に近づけてください</translation>
    </message>
    <message>
        <source>The map has changed: what was moved is not there any more</source>
        <translation>地図が変わりました。動かしていたものはもうありません</translation>
    </message>
    <message>
        <source>%1 from scan %2 on (scans: %3)</source>
        <translation>%1 のスキャン %2 以降（スキャン: %3）</translation>
    </message>
    <message>
        <source>all of %1 (scans: %2)</source>
        <translation>%1 のすべて（スキャン: %2）</translation>
    </message>
    <message>
        <source>the storey of scan %1 (scans: %2)</source>
        <translation>スキャン %1 の階（スキャン: %2）</translation>
    </message>
    <message>
        <source>the part of the map with scan %1 (scans: %2)</source>
        <translation>スキャン %1 を含む地図の部分（スキャン: %2）</translation>
    </message>
    <message>
        <source>It is laid onto the rest of the map…</source>
        <translation>地図の残りに重ねています…</translation>
    </message>
    <message>
        <source>It is made ready…</source>
        <translation>準備しています…</translation>
    </message>
    <message>
        <source>Nothing of the rest of the map is there</source>
        <translation>そこには地図の残りがありません</translation>
    </message>
    <message>
        <source>On the rest of the map: %1, seam %2 m</source>
        <translation>地図の残りとの重なり: %1、ずれ %2 m</translation>
    </message>
    <message>
        <source>Another station makes the map: it is moved there</source>
        <translation>地図は別の局が作っています。そこで動かしてください</translation>
    </message>
    <message>
        <source>Left there; links to the rest of the map: %1</source>
        <translation>そこに置きました。地図の残りとのリンク: %1</translation>
    </message>
    <message>
        <source>A run of scans, a robot&apos;s, a storey, a part that has not met the rest, or one scan alone: drag it to where it belongs, Shift+drag turns it</source>
        <translation>一続きのスキャン、ロボット一台分、一つの階、まだ残りとつながっていない部分、またはスキャン一つだけを、あるべき場所へドラッグします。Shift+ドラッグで回します</translation>
    </message>
    <message>
        <source>From the chosen scan on, all of its robot, its storey, its part of the map, this scan alone</source>
        <translation>選んだスキャン以降、そのロボットのすべて、その階、地図のその部分、このスキャンだけ</translation>
    </message>
    <message>
        <source>scan %1 of %2 alone</source>
        <translation>%2のスキャン%1のみ</translation>
    </message>
</context>
<context>
    <name>leitstand::ThermalOverlay</name>
    <message>
        <source>%1 °C</source>
        <translation>%1 °C</translation>
    </message>
    <message>
        <source>%1 person?</source>
        <translation>%1 人物?</translation>
    </message>
    <message>
        <source>person?</source>
        <translation>人物?</translation>
    </message>
</context>
<context>
    <name>leitstand::TidyingFeature</name>
    <message>
        <source>T&amp;idy the map</source>
        <translation>地図を整える(&amp;I)</translation>
    </message>
    <message>
        <source>Matches all scans that overlap, whenever they were taken, and moves them together, which takes a while; the review is opened again then. What was recorded stays as it is, and it can be taken back</source>
        <translation>いつ取得されたかにかかわらず、重なるすべてのスキャンを照合してまとめて動かします。時間がかかり、終わるとレビューを開き直します。記録されたものは変わらず、取り消せます</translation>
    </message>
    <message>
        <source>Take the tidying &amp;back</source>
        <translation>地図の整えを取り消す(&amp;B)</translation>
    </message>
    <message>
        <source>Scans are where they were before the map was tidied; the review is opened again then</source>
        <translation>スキャンを地図を整える前の位置に戻します。終わるとレビューを開き直します</translation>
    </message>
    <message>
        <source>Sho&amp;w the map before the tidying</source>
        <translation>整える前の地図を表示(&amp;W)</translation>
    </message>
    <message>
        <source>In violet: where scans lay before the map was tidied</source>
        <translation>紫: 地図を整える前のスキャンの位置</translation>
    </message>
    <message>
        <source>Take back</source>
        <translation>取り消す</translation>
    </message>
    <message>
        <source>Hide</source>
        <translation>隠す</translation>
    </message>
    <message>
        <source>A report is being written, or scans are being registered again: tidy the map after that</source>
        <translation>レポートの書き出しまたは再位置合わせの途中です。終わってから地図を整えてください</translation>
    </message>
    <message>
        <source>Violet: the map before it was tidied. Scans moved: %1, by up to %2 m.</source>
        <translation>紫: 整える前の地図。動いたスキャン: %1、最大 %2 m。</translation>
    </message>
</context>
<context>
    <name>leitstand::Timeline</name>
    <message>
        <source>%1 confirmed</source>
        <translation>%1 確定</translation>
    </message>
    <message>
        <source>%1 discarded</source>
        <translation>%1 破棄</translation>
    </message>
    <message>
        <source>%1 filed</source>
        <translation>%1 登録</translation>
    </message>
    <message>
        <source>a victim</source>
        <translation>被災者</translation>
    </message>
    <message>
        <source>heat</source>
        <translation>熱</translation>
    </message>
    <message>
        <source>motion</source>
        <translation>動き</translation>
    </message>
    <message>
        <source>sound</source>
        <translation>音</translation>
    </message>
    <message>
        <source>CO₂</source>
        <translation>CO₂</translation>
    </message>
    <message>
        <source>a code</source>
        <translation>コード</translation>
    </message>
    <message>
        <source>a hazard sign</source>
        <translation>危険物標識</translation>
    </message>
    <message>
        <source>the robot saw %1</source>
        <translation>ロボットが%1を検出</translation>
    </message>
    <message>
        <source>the robot saw %1: %2</source>
        <translation>ロボットが%1を検出: %2</translation>
    </message>
    <message>
        <source>alarm: %1</source>
        <translation>警報: %1</translation>
    </message>
    <message>
        <source>note: %1</source>
        <translation>メモ: %1</translation>
    </message>
    <message>
        <source>undone</source>
        <translation>取り消し</translation>
    </message>
    <message>
        <source>undone: %1</source>
        <translation>取り消し: %1</translation>
    </message>
    <message>
        <source>decision on scans</source>
        <translation>スキャンの判断</translation>
    </message>
    <message>
        <source>mode: %1</source>
        <translation>モード: %1</translation>
    </message>
    <message>
        <source>mode: %1 (%2)</source>
        <translation>モード: %1（%2）</translation>
    </message>
    <message>
        <source>bumped: %1</source>
        <translation>衝突: %1</translation>
    </message>
    <message>
        <source>recording ended (%1)</source>
        <translation>記録終了（%1）</translation>
    </message>
    <message>
        <source>recording began (%1)</source>
        <translation>記録開始（%1）</translation>
    </message>
    <message>
        <source>stands</source>
        <translation>停止</translation>
    </message>
    <message>
        <source>backwards %1</source>
        <translation>逆再生 %1</translation>
    </message>
    <message>
        <source>an object</source>
        <translation>物体</translation>
    </message>
    <message>
        <source>the robot&apos;s own sighting</source>
        <translation>ロボット自身の発見報告</translation>
    </message>
    <message>
        <source>candidate dismissed: %1</source>
        <translation>候補を却下: %1</translation>
    </message>
    <message>
        <source>candidate: %1, %2</source>
        <comment>a victim, 72 %</comment>
        <translation>候補: %1、%2</translation>
    </message>
    <message>
        <source>%1 moved %2 m, since %3 (%4)</source>
        <translation>%1 が %2 m 移動、理由: %3（%4）</translation>
    </message>
    <message>
        <source>done again</source>
        <translation>やり直し</translation>
    </message>
    <message>
        <source>done again: %1</source>
        <translation>やり直し: %1</translation>
    </message>
    <message>
        <source>a victim&apos;s tag</source>
        <translation>被災者のタグ</translation>
    </message>
</context>
<context>
    <name>leitstand::TimelineBar</name>
    <message>
        <source>Timeline of the mission</source>
        <translation>ミッションのタイムライン</translation>
    </message>
    <message>
        <source>Click or drag to go to a moment; arrows step by 1 s, with Shift by 10 s</source>
        <translation>クリックまたはドラッグで時点へ移動。矢印で 1 s、Shift 併用で 10 s ずつ</translation>
    </message>
    <message>
        <source>reads through the mission…</source>
        <translation>ミッションを読み込み中…</translation>
    </message>
</context>
<context>
    <name>leitstand::TimelineFeature</name>
    <message>
        <source>&amp;Previous mark</source>
        <translation>前のマーク(&amp;P)</translation>
    </message>
    <message>
        <source>Back to the mark before</source>
        <translation>1 つ前のマークへ戻る</translation>
    </message>
    <message>
        <source>Play &amp;backwards</source>
        <translation>逆再生(&amp;B)</translation>
    </message>
    <message>
        <source>Plays backwards, or stands</source>
        <translation>逆再生、または停止</translation>
    </message>
    <message>
        <source>&amp;Play</source>
        <translation>再生(&amp;P)</translation>
    </message>
    <message>
        <source>Plays, or stands</source>
        <translation>再生、または停止</translation>
    </message>
    <message>
        <source>&amp;Next mark</source>
        <translation>次のマーク(&amp;N)</translation>
    </message>
    <message>
        <source>On to the next mark</source>
        <translation>次のマークへ進む</translation>
    </message>
    <message>
        <source>&amp;Slower</source>
        <translation>遅く(&amp;S)</translation>
    </message>
    <message>
        <source>Plays slower, down to a tenth</source>
        <translation>再生を遅くする（最小 10 分の 1）</translation>
    </message>
    <message>
        <source>&amp;Faster</source>
        <translation>速く(&amp;F)</translation>
    </message>
    <message>
        <source>Plays faster, up to 32 times</source>
        <translation>再生を速くする（最大 32 倍）</translation>
    </message>
    <message>
        <source>Next &amp;victim</source>
        <translation>次の被災者(&amp;V)</translation>
    </message>
    <message>
        <source>Next &amp;alarm</source>
        <translation>次の警報(&amp;A)</translation>
    </message>
    <message>
        <source>On to the next alarm, from the last to the first</source>
        <translation>次の警報へ。最後の次は最初に戻る</translation>
    </message>
    <message>
        <source>Next n&amp;ote</source>
        <translation>次のメモ(&amp;O)</translation>
    </message>
    <message>
        <source>On to the next note, from the last to the first</source>
        <translation>次のメモへ。最後の次は最初に戻る</translation>
    </message>
    <message>
        <source>&amp;Map as finished</source>
        <translation>終了時点の地図(&amp;M)</translation>
    </message>
    <message>
        <source>The map as the mission ended, with all corrections; else as it was then</source>
        <translation>すべての訂正を含むミッション終了時の地図。オフではその時点の地図</translation>
    </message>
    <message>
        <source>Plays at %1</source>
        <translation>%1 で再生</translation>
    </message>
    <message>
        <source>There is no such mark</source>
        <translation>該当するマークなし</translation>
    </message>
    <message>
        <source>Previous v&amp;ictim</source>
        <translation>前の被災者(&amp;I)</translation>
    </message>
    <message>
        <source>Stop &amp;mapping</source>
        <translation>地図作成を中止(&amp;M)</translation>
    </message>
    <message>
        <source>No station made a map of this mission, so that its point clouds are registered first; stopped, the review has those that are registered by then</source>
        <translation>このミッションの地図がないため、先に点群の位置合わせを行います。中止すると、それまでに位置合わせした分で閲覧します</translation>
    </message>
    <message>
        <source>registers the point clouds, since no station made a map: %1 %</source>
        <translation>地図がないため点群を位置合わせしています: %1 %</translation>
    </message>
    <message>
        <source>On to where the next victim was filed or changed, from the last to the first</source>
        <translation>次に被災者が登録または変更された時点へ（最後の次は最初）</translation>
    </message>
    <message>
        <source>Back to where the victim before was filed or changed, from the first to the last</source>
        <translation>前に被災者が登録または変更された時点へ（最初の前は最後）</translation>
    </message>
    <message>
        <source>Next &amp;hazard</source>
        <translation>次の危険物(&amp;H)</translation>
    </message>
    <message>
        <source>On to the next hazard sign, QR code or object, from the last to the first</source>
        <translation>次の危険物標識・QR コード・対象物へ（最後の次は最初）</translation>
    </message>
    <message>
        <source>Next &amp;candidate</source>
        <translation>次の候補(&amp;C)</translation>
    </message>
    <message>
        <source>On to what the station believed next to have found, from the last to the first</source>
        <translation>ステーションが次に発見と判断した時点へ（最後の次は最初）</translation>
    </message>
</context>
<context>
    <name>leitstand::TonePlayer</name>
    <message>
        <source>No sound device: alarms are seen, not heard.</source>
        <translation>音声デバイスなし: 警報は表示のみ、音は出ない。</translation>
    </message>
    <message>
        <source>The sound device does not work: alarms are seen, not heard.</source>
        <translation>音声デバイスが動作しない: 警報は表示のみ、音は出ない。</translation>
    </message>
</context>
<context>
    <name>leitstand::TopicRowsModel</name>
    <message>
        <source>Topic</source>
        <translation>トピック</translation>
    </message>
    <message>
        <source>Type</source>
        <translation>型</translation>
    </message>
    <message>
        <source>Nodes</source>
        <translation>ノード</translation>
    </message>
    <message>
        <source>Nobody publishes it</source>
        <translation>誰も送信していません</translation>
    </message>
</context>
<context>
    <name>leitstand::TopicWords</name>
    <message>
        <source>Nothing came yet</source>
        <translation>まだ何も届いていません</translation>
    </message>
    <message>
        <source>%1 ms ago</source>
        <translation>%1 ms前</translation>
    </message>
    <message>
        <source>%1 s ago</source>
        <translation>%1 s前</translation>
    </message>
    <message>
        <source>%1 Hz · %2 Mbit/s · %3</source>
        <translation>%1 Hz · %2 Mbit/s · %3</translation>
    </message>
</context>
<context>
    <name>leitstand::Topics</name>
    <message>
        <source>{} numbers: {} ...</source>
        <translation>数値{}個: {} ...</translation>
    </message>
    <message>
        <source> ({} to {})</source>
        <translation>（{}～{}）</translation>
    </message>
    <message>
        <source>{} elements</source>
        <translation>要素{}個</translation>
    </message>
    <message>
        <source>The publisher is asked what {} is made of</source>
        <translation>{} の構成を発行元に問い合わせています</translation>
    </message>
    <message>
        <source>The text of {} is not known here, and its publisher does not tell it (ROS 2 Iron and later do): its fields cannot be shown</source>
        <translation>{} の定義はここになく、発行元も教えません (ROS 2 Iron 以降で可能): フィールドは表示できません</translation>
    </message>
    <message>
        <source>What its publisher tells of {} is not read: {}</source>
        <translation>{} について発行元が答えた内容を読めません: {}</translation>
    </message>
    <message>
        <source>The text of {} is not known here, and {} does not answer what it is</source>
        <translation>{} の定義はここになく、{} も答えません</translation>
    </message>
</context>
<context>
    <name>leitstand::TopicsFeature</name>
    <message>
        <source>&amp;Topics of the network</source>
        <translation>ネットワークのトピック(&amp;T)</translation>
    </message>
    <message>
        <source>Lists all topics, and shows what comes on one of them</source>
        <translation>すべてのトピックを一覧し、その一つに届く内容を表示します</translation>
    </message>
    <message>
        <source> · not all of its fields</source>
        <translation> · フィールドは一部のみ</translation>
    </message>
</context>
<context>
    <name>leitstand::TopicsPanel</name>
    <message>
        <source>Topics</source>
        <translation>トピック</translation>
    </message>
    <message>
        <source>Words of topic, type or node</source>
        <translation>トピック、型、ノードの語</translation>
    </message>
    <message>
        <source>Topics of the domain</source>
        <translation>ドメインのトピック</translation>
    </message>
    <message>
        <source>The newest message of the chosen topic</source>
        <translation>選択中のトピックの最新メッセージ</translation>
    </message>
    <message>
        <source>Choose a topic: what comes on it is shown here, and only then loads the link</source>
        <translation>トピックを選ぶと届く内容がここに表示され、選んだときだけ回線を使います</translation>
    </message>
</context>
<context>
    <name>leitstand::TransportBar</name>
    <message>
        <source>Speed of the review</source>
        <translation>レビューの速度</translation>
    </message>
    <message>
        <source>Moment that is shown</source>
        <translation>表示中の時点</translation>
    </message>
    <message>
        <source>%1   %2 of %3</source>
        <translation>%1   %2 / %3</translation>
    </message>
</context>
<context>
    <name>leitstand::TrendPlot</name>
    <message>
        <source>Plot</source>
        <translation>グラフ</translation>
    </message>
</context>
<context>
    <name>leitstand::Verdict</name>
    <message>
        <source>The iteration came to rest.</source>
        <translation>反復は収束した。</translation>
    </message>
    <message>
        <source>The iteration ended swinging between two poses.</source>
        <translation>反復は 2 つの位置姿勢の間を振動したまま終了した。</translation>
    </message>
    <message>
        <source>The limit of iterations was reached before the pose came to rest.</source>
        <translation>位置姿勢が収束する前に反復の上限に達した。</translation>
    </message>
    <message>
        <source>Too few pairs of points: the scan stands where it was expected. A larger maximum distance may help.</source>
        <translation>点対が少なすぎる: スキャンは予想位置のまま。最大距離を大きくすると改善する可能性あり。</translation>
    </message>
    <message>
        <source>The registration was cancelled.</source>
        <translation>位置合わせは中止された。</translation>
    </message>
    <message>
        <source>reference</source>
        <translation>基準</translation>
    </message>
    <message>
        <source>certain</source>
        <translation>確実</translation>
    </message>
    <message>
        <source>uncertain</source>
        <translation>不確実</translation>
    </message>
    <message>
        <source>not converged</source>
        <translation>未収束</translation>
    </message>
    <message>
        <source>The first scan defines the map&apos;s frame; the others are registered to it.</source>
        <translation>最初のスキャンが地図の座標系を定め、他はそれに位置合わせする。</translation>
    </message>
    <message>
        <source>Some direction is hardly held, as along a bare corridor: certainty %1, below %2.</source>
        <translation>特徴のない通路のように、ある方向の拘束が弱い: 確実度 %1、%2 未満。</translation>
    </message>
    <message>
        <source>Every direction is held: certainty %1 (uncertain below %2).</source>
        <translation>全方向が拘束されている: 確実度 %1（%2 未満は不確実）。</translation>
    </message>
</context>
<context>
    <name>leitstand::VictimChoices</name>
    <message>
        <source>unknown</source>
        <translation>不明</translation>
    </message>
    <message>
        <source>surface: lies open</source>
        <translation>地表: 露出</translation>
    </message>
    <message>
        <source>trapped: partly covered</source>
        <translation>挟まれ: 一部埋没</translation>
    </message>
    <message>
        <source>void: in a hollow</source>
        <translation>空隙: 空洞内</translation>
    </message>
    <message>
        <source>entombed: covered</source>
        <translation>埋没: 覆われている</translation>
    </message>
    <message>
        <source>yellow</source>
        <translation>黄</translation>
    </message>
    <message>
        <source>orange</source>
        <translation>橙</translation>
    </message>
    <message>
        <source>red</source>
        <translation>赤</translation>
    </message>
    <message>
        <source>Form</source>
        <translation>形状</translation>
    </message>
    <message>
        <source>Motion</source>
        <translation>動き</translation>
    </message>
    <message>
        <source>Heat</source>
        <translation>熱</translation>
    </message>
    <message>
        <source>°C</source>
        <translation>°C</translation>
    </message>
    <message>
        <source>Sound</source>
        <translation>音</translation>
    </message>
    <message>
        <source>CO₂</source>
        <translation>CO₂</translation>
    </message>
    <message>
        <source>ppm</source>
        <translation>ppm</translation>
    </message>
    <message>
        <source>absent</source>
        <translation>なし</translation>
    </message>
    <message>
        <source>present</source>
        <translation>あり</translation>
    </message>
    <message>
        <source>whole body</source>
        <translation>全身</translation>
    </message>
    <message>
        <source>arm</source>
        <translation>腕</translation>
    </message>
    <message>
        <source>hand</source>
        <translation>手</translation>
    </message>
    <message>
        <source>waving</source>
        <translation>手を振る</translation>
    </message>
    <message>
        <source>breathing</source>
        <translation>呼吸</translation>
    </message>
    <message>
        <source>face</source>
        <translation>顔</translation>
    </message>
    <message>
        <source>calling</source>
        <translation>呼び声</translation>
    </message>
    <message>
        <source>tapping</source>
        <translation>叩く音</translation>
    </message>
    <message>
        <source>rising</source>
        <translation>上昇</translation>
    </message>
    <message>
        <source>steady</source>
        <translation>一定</translation>
    </message>
    <message>
        <source>%1 …</source>
        <comment>what one may write: waving, breathing …</comment>
        <translation>%1 …</translation>
    </message>
    <message>
        <source>, </source>
        <comment>between words</comment>
        <translation>、</translation>
    </message>
    <message>
        <source>beside a wall</source>
        <translation>壁際</translation>
    </message>
    <message>
        <source>in a corner</source>
        <translation>隅</translation>
    </message>
    <message>
        <source>behind a door</source>
        <translation>ドアの後ろ</translation>
    </message>
    <message>
        <source>under a table</source>
        <translation>机の下</translation>
    </message>
    <message>
        <source>in a box</source>
        <translation>箱の中</translation>
    </message>
    <message>
        <source>the way is narrow</source>
        <translation>道が狭い</translation>
    </message>
    <message>
        <source>the way is steep</source>
        <translation>道が急</translation>
    </message>
</context>
<context>
    <name>leitstand::VictimForm</name>
    <message>
        <source>Situation</source>
        <translation>状況</translation>
    </message>
    <message>
        <source>Area</source>
        <translation>エリア</translation>
    </message>
    <message>
        <source>Tag</source>
        <translation>札</translation>
    </message>
    <message>
        <source>what is written on it</source>
        <translation>札に書かれている内容</translation>
    </message>
    <message>
        <source>Remarks</source>
        <translation>備考</translation>
    </message>
    <message>
        <source>how to get there, what to mind</source>
        <translation>行き方、注意点</translation>
    </message>
    <message>
        <source>Form of the chosen find</source>
        <translation>選択した発見のフォーム</translation>
    </message>
    <message>
        <source>%1, in words</source>
        <translation>%1、説明</translation>
    </message>
    <message>
        <source>%1, measured</source>
        <translation>%1、測定値</translation>
    </message>
    <message>
        <source>%1 · %2</source>
        <translation>%1 · %2</translation>
    </message>
    <message>
        <source>Choose a find to fill in its form</source>
        <translation>発見を選択してフォームに記入</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Where the find is; unknown: in the area of the mission</source>
        <translation>発見物の場所。不明ならミッションの区域とみなします</translation>
    </message>
    <message>
        <source>How the victim lies there</source>
        <translation>要救助者の状態</translation>
    </message>
    <message>
        <source>Done</source>
        <translation>完了</translation>
    </message>
    <message>
        <source>Closes the form; what was filled in is kept already</source>
        <translation>フォームを閉じます（入力内容は保存済み）</translation>
    </message>
</context>
<context>
    <name>leitstand::VictimListModel</name>
    <message>
        <source>%1, %2</source>
        <comment>hazard, confirmed</comment>
        <translation>%1、%2</translation>
    </message>
    <message>
        <source>Find</source>
        <translation>発見</translation>
    </message>
    <message>
        <source>State</source>
        <translation>状態</translation>
    </message>
    <message>
        <source>Where</source>
        <translation>位置</translation>
    </message>
    <message>
        <source>Signs</source>
        <translation>兆候</translation>
    </message>
    <message>
        <source>Found</source>
        <comment>when</comment>
        <translation>発見時刻</translation>
    </message>
</context>
<context>
    <name>leitstand::VictimRows</name>
    <message>
        <source>no %1</source>
        <comment>a sign of life</comment>
        <translation>%1なし</translation>
    </message>
    <message>
        <source>heat</source>
        <translation>熱</translation>
    </message>
    <message>
        <source>heat %1 °C</source>
        <translation>熱 %1 °C</translation>
    </message>
    <message>
        <source>motion</source>
        <translation>動き</translation>
    </message>
    <message>
        <source>CO₂</source>
        <translation>CO₂</translation>
    </message>
    <message>
        <source>CO₂ %1 ppm</source>
        <translation>CO₂ %1 ppm</translation>
    </message>
    <message>
        <source>the robot&apos;s own</source>
        <translation>ロボットの検出</translation>
    </message>
    <message>
        <source>confirmed</source>
        <translation>確定</translation>
    </message>
    <message>
        <source>unconfirmed</source>
        <translation>未確定</translation>
    </message>
    <message>
        <source>candidate %1</source>
        <translation>候補 %1</translation>
    </message>
    <message>
        <source>victim</source>
        <translation>被災者</translation>
    </message>
    <message>
        <source>hazard</source>
        <translation>危険物</translation>
    </message>
    <message>
        <source>QR code</source>
        <translation>QRコード</translation>
    </message>
    <message>
        <source>object</source>
        <translation>対象物</translation>
    </message>
    <message>
        <source>%1 m</source>
        <translation>%1 m</translation>
    </message>
    <message>
        <source>%1, ahead</source>
        <translation>%1、前方</translation>
    </message>
    <message>
        <source>%1, behind</source>
        <translation>%1、後方</translation>
    </message>
    <message>
        <source>%1, %2° left</source>
        <translation>%1、左 %2°</translation>
    </message>
    <message>
        <source>%1, %2° right</source>
        <translation>%1、右 %2°</translation>
    </message>
    <message>
        <source>form</source>
        <translation>形状</translation>
    </message>
    <message>
        <source> °C</source>
        <translation> °C</translation>
    </message>
    <message>
        <source>sound</source>
        <translation>音</translation>
    </message>
    <message>
        <source> ppm</source>
        <translation> ppm</translation>
    </message>
    <message>
        <source>1 victim</source>
        <translation>被災者 1 名</translation>
    </message>
    <message>
        <source>%1 victims</source>
        <translation>被災者 %1 名</translation>
    </message>
    <message>
        <source>, %1 not confirmed</source>
        <translation>, 未確定 %1</translation>
    </message>
    <message>
        <source> · %1 others</source>
        <translation> · その他 %1</translation>
    </message>
    <message>
        <source> · %1 candidates</source>
        <translation> · 候補 %1</translation>
    </message>
    <message>
        <source> · %1 discarded</source>
        <translation>・破棄 %1</translation>
    </message>
    <message>
        <source>tag %1</source>
        <translation>タグ %1</translation>
    </message>
    <message>
        <source> · 1 other</source>
        <translation> · その他 1</translation>
    </message>
    <message>
        <source> · 1 candidate</source>
        <translation> · 候補 1</translation>
    </message>
</context>
<context>
    <name>leitstand::VictimsFeature</name>
    <message>
        <source>&amp;Victim here</source>
        <translation>ここに被災者(&amp;V)</translation>
    </message>
    <message>
        <source>F Victim</source>
        <translation>F 被災者</translation>
    </message>
    <message>
        <source>Keeps what the robot sees as a victim: the sharpest pictures, heat, gas, scan and place</source>
        <translation>ロボットが見ているものを被災者として登録: 最も鮮明な映像、熱、ガス、スキャン、位置</translation>
    </message>
    <message>
        <source>Con&amp;firm the find</source>
        <translation>発見を確定(&amp;F)</translation>
    </message>
    <message>
        <source>V Confirm</source>
        <translation>V 確定</translation>
    </message>
    <message>
        <source>Confirms the chosen find, or the one that was filed last; files a chosen candidate</source>
        <translation>選択した発見、または最後に登録した発見を確定。選択した候補は登録</translation>
    </message>
    <message>
        <source>Ha&amp;zard here</source>
        <translation>ここに危険物(&amp;Z)</translation>
    </message>
    <message>
        <source>Hazard</source>
        <translation>危険物</translation>
    </message>
    <message>
        <source>The same for a hazard sign</source>
        <translation>危険物標識を同様に登録</translation>
    </message>
    <message>
        <source>&amp;QR code here</source>
        <translation>ここに QRコード(&amp;Q)</translation>
    </message>
    <message>
        <source>Code</source>
        <translation>コード</translation>
    </message>
    <message>
        <source>The same for a QR code</source>
        <translation>QRコードを同様に登録</translation>
    </message>
    <message>
        <source>&amp;Object here</source>
        <translation>ここに対象物(&amp;O)</translation>
    </message>
    <message>
        <source>Object</source>
        <translation>対象物</translation>
    </message>
    <message>
        <source>The same for an object of interest</source>
        <translation>対象物を同様に登録</translation>
    </message>
    <message>
        <source>&amp;Discard the find</source>
        <translation>発見を破棄(&amp;D)</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>破棄</translation>
    </message>
    <message>
        <source>&amp;Merge with the nearest</source>
        <translation>最寄りと統合(&amp;M)</translation>
    </message>
    <message>
        <source>Merge</source>
        <translation>統合</translation>
    </message>
    <message>
        <source>The chosen find is the same as the nearest one of its kind, which gets its evidence</source>
        <translation>選択した発見は最寄りの同種の発見と同一。証拠はそちらに移る</translation>
    </message>
    <message>
        <source>Undo the last &amp;entry on finds</source>
        <translation>発見の最後の操作を取り消す(&amp;E)</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>取り消し</translation>
    </message>
    <message>
        <source>Takes back what was filed, changed, confirmed or discarded last</source>
        <translation>最後の登録・変更・確定・破棄を取り消す</translation>
    </message>
    <message>
        <source>Mo&amp;ve the find on the map</source>
        <translation>発見を地図上で移動(&amp;V)</translation>
    </message>
    <message>
        <source>Click on the map where the chosen find is; without one a new victim is filed there</source>
        <translation>地図上で選択した発見の位置をクリック。未選択なら新しい被災者をそこに登録</translation>
    </message>
    <message>
        <source>Form: &amp;next field</source>
        <translation>フォーム: 次の項目(&amp;N)</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>次</translation>
    </message>
    <message>
        <source>Of the chosen find&apos;s form</source>
        <translation>選択した発見のフォームの項目</translation>
    </message>
    <message>
        <source>Form: &amp;previous field</source>
        <translation>フォーム: 前の項目(&amp;P)</translation>
    </message>
    <message>
        <source>Previous</source>
        <translation>前</translation>
    </message>
    <message>
        <source>Form: next &amp;choice</source>
        <translation>フォーム: 次の選択肢(&amp;C)</translation>
    </message>
    <message>
        <source>Change</source>
        <translation>変更</translation>
    </message>
    <message>
        <source>Unknown, absent, present; situations; areas</source>
        <translation>不明、なし、あり。状況。エリア</translation>
    </message>
    <message>
        <source>Click where %1 is · right button: not at all</source>
        <translation>%1 の位置をクリック · 右ボタン: 中止</translation>
    </message>
    <message>
        <source>Click where the victim is · right button: not at all</source>
        <translation>被災者の位置をクリック · 右ボタン: 中止</translation>
    </message>
    <message>
        <source>Choose the find that is none</source>
        <translation>誤りの発見を先に選択</translation>
    </message>
    <message>
        <source>Choose the find that is part of another one</source>
        <translation>他の一部である発見を先に選択</translation>
    </message>
    <message>
        <source>Takes the chosen find or candidate, or the newest find, off the list; undo brings it back</source>
        <translation>選択した発見物または候補、あるいは最新の発見物をリストから外します。元に戻すと復帰します</translation>
    </message>
    <message>
        <source>Choose a filed find, to fill in its form</source>
        <translation>記入するには登録済みの発見物を選んでください</translation>
    </message>
    <message>
        <source>Nothing to choose from here: what was typed stays</source>
        <translation>ここに選択肢はありません。入力した文字はそのままです</translation>
    </message>
</context>
<context>
    <name>leitstand::VictimsPanel</name>
    <message>
        <source>Nothing found yet. F files what the robot sees.</source>
        <translation>発見はまだない。F でロボットが見ているものを登録。</translation>
    </message>
    <message>
        <source>Victims and other finds</source>
        <translation>被災者とその他の発見</translation>
    </message>
    <message>
        <source>Victims, other finds and candidates</source>
        <translation>被災者、その他の発見、候補</translation>
    </message>
    <message>
        <source>Nothing was found yet</source>
        <translation>発見はまだない</translation>
    </message>
    <message>
        <source>Finds; Return goes to the moment when the chosen one was found</source>
        <translation>発見一覧。Enter で選んだ発見の時刻へ移動</translation>
    </message>
</context>
<context>
    <name>leitstand::ViewCommands</name>
    <message>
        <source>&amp;Points</source>
        <translation>点群(&amp;P)</translation>
    </message>
    <message>
        <source>Shows the scans&apos; points</source>
        <translation>スキャンの点を表示</translation>
    </message>
    <message>
        <source>&amp;Voxels</source>
        <translation>ボクセル(&amp;V)</translation>
    </message>
    <message>
        <source>Shows the map as cubes</source>
        <translation>地図を立方体で表示</translation>
    </message>
    <message>
        <source>&amp;Floor plan</source>
        <translation>平面図(&amp;F)</translation>
    </message>
    <message>
        <source>Shows the map from above with a 1 m grid</source>
        <translation>地図を 1 m グリッド付きで上から表示</translation>
    </message>
    <message>
        <source>Colour by &amp;label</source>
        <translation>ラベルで色分け(&amp;L)</translation>
    </message>
    <message>
        <source>Floor blue, wall yellow, ceiling red</source>
        <translation>床は青、壁は黄、天井は赤</translation>
    </message>
    <message>
        <source>Colour by &amp;scan</source>
        <translation>スキャンで色分け(&amp;S)</translation>
    </message>
    <message>
        <source>A colour for each scan: shows how well they fit</source>
        <translation>スキャンごとに色分け: 適合の良さを確認</translation>
    </message>
    <message>
        <source>Colour by &amp;height</source>
        <translation>高さで色分け(&amp;H)</translation>
    </message>
    <message>
        <source>Colour by &amp;range</source>
        <translation>距離で色分け(&amp;R)</translation>
    </message>
    <message>
        <source>Distance from the scanner</source>
        <translation>スキャナからの距離</translation>
    </message>
    <message>
        <source>&amp;Dark theme</source>
        <translation>ダークテーマ(&amp;D)</translation>
    </message>
    <message>
        <source>L&amp;ight theme</source>
        <translation>ライトテーマ(&amp;I)</translation>
    </message>
    <message>
        <source>For sunlit places</source>
        <translation>日の当たる場所用</translation>
    </message>
    <message>
        <source>R&amp;eset camera</source>
        <translation>視点をリセット(&amp;E)</translation>
    </message>
    <message>
        <source>Shows the whole map</source>
        <translation>地図全体を表示</translation>
    </message>
    <message>
        <source>Camera from &amp;above</source>
        <translation>上からの視点(&amp;A)</translation>
    </message>
    <message>
        <source>Camera from the s&amp;ide</source>
        <translation>横からの視点(&amp;I)</translation>
    </message>
    <message>
        <source>&amp;Before registration</source>
        <translation>位置合わせ前(&amp;B)</translation>
    </message>
    <message>
        <source>Shows the scans where they were expected before registration</source>
        <translation>スキャンを位置合わせ前の予想位置に表示</translation>
    </message>
    <message>
        <source>Clip by hei&amp;ght</source>
        <translation>高さで切り取り(&amp;G)</translation>
    </message>
    <message>
        <source>Shows only a slice of the map, between two heights</source>
        <translation>2 つの高さの間だけ地図を表示</translation>
    </message>
    <message>
        <source>&amp;Measure</source>
        <translation>計測(&amp;M)</translation>
    </message>
    <message>
        <source>Click two points for their distance; Esc ends it</source>
        <translation>2 点をクリックして距離を計測。Esc で終了</translation>
    </message>
    <message>
        <source>Click two points for their distance; the same key again ends it</source>
        <translation>二点をクリックして距離を測る。同じキーで終える</translation>
    </message>
    <message>
        <source>Colour by r&amp;obot</source>
        <translation>ロボットで色分け(&amp;O)</translation>
    </message>
    <message>
        <source>Which robot&apos;s scanner saw it</source>
        <translation>どのロボットのスキャナが見たか</translation>
    </message>
    <message>
        <source>Colour by &amp;intensity</source>
        <translation>反射強度で色分け(&amp;I)</translation>
    </message>
    <message>
        <source>How strongly surfaces throw the laser back</source>
        <translation>面がレーザーをどれだけ強く反射するか</translation>
    </message>
    <message>
        <source>Colour by a&amp;ge</source>
        <translation>経過時間で色分け(&amp;G)</translation>
    </message>
    <message>
        <source>When it came into the map: what is bright is new</source>
        <translation>地図に入った時期:明るいほど新しい</translation>
    </message>
</context>
<context>
    <name>leitstand::VirtualScanPane</name>
    <message>
        <source>%1 m</source>
        <translation>%1 m</translation>
    </message>
    <message>
        <source>Virtual scan</source>
        <translation>仮想スキャン</translation>
    </message>
    <message>
        <source>nearest obstacle %1 m</source>
        <translation>最近接の障害物 %1 m</translation>
    </message>
    <message>
        <source>What is around the robot, its front up.
Yellow: walls. Dots: obstacles, fainter the longer ago they were seen.
Dashed: where it goes. The wheel, + and − zoom; a double click resets.</source>
        <translation>ロボットの周囲、前方が上。
黄: 壁。点: 障害物、見てから時間が経つほど薄い。
破線: 進路。ホイール、+、− でズーム。ダブルクリックでリセット。</translation>
    </message>
</context>
<context>
    <name>leitstand::WireWords</name>
    <message>
        <source>robot offers {0}, we asked for {1}</source>
        <translation>ロボットの提供は {0}、こちらの要求は {1}</translation>
    </message>
    <message>
        <source>we offer {1}, robot asks for {0}</source>
        <translation>こちらの提供は {1}、ロボットの要求は {0}</translation>
    </message>
    <message>
        <source>robot sends {0}, we expected {1}</source>
        <translation>ロボットの送信は {0}、こちらの期待は {1}</translation>
    </message>
    <message>
        <source>robot expects {0}, we send {1}</source>
        <translation>ロボットの期待は {0}、こちらの送信は {1}</translation>
    </message>
    <message>
        <source>robot&apos;s topic has keys, ours has none as in ROS 2</source>
        <translation>ロボットのトピックにはキーがあり、こちらは ROS 2 と同じくキーなし</translation>
    </message>
    <message>
        <source>robot offers exclusive ownership, we share as ROS 2 does</source>
        <translation>ロボットの提供は exclusive ownership、こちらは ROS 2 と同じ shared</translation>
    </message>
    <message>
        <source>robot asks for exclusive ownership, we share as ROS 2 does</source>
        <translation>ロボットの要求は exclusive ownership、こちらは ROS 2 と同じ shared</translation>
    </message>
    <message>
        <source>robot is in partition &quot;{0}&quot;, we are in the default one</source>
        <translation>ロボットはパーティション「{0}」、こちらは既定のパーティション</translation>
    </message>
    <message>
        <source>robot writes XCDR2 only, we read XCDR1</source>
        <translation>ロボットは XCDR2 のみ書き込み、こちらは XCDR1 を読み取り</translation>
    </message>
    <message>
        <source>robot reads XCDR2 only, we write XCDR1</source>
        <translation>ロボットは XCDR2 のみ読み取り、こちらは XCDR1 を書き込み</translation>
    </message>
    <message>
        <source>robot asks for a liveliness that we do not offer</source>
        <translation>ロボットが要求する liveliness をこちらは提供していません</translation>
    </message>
    <message>
        <source>security: permissions or governance of one side do not let them talk</source>
        <translation>セキュリティ：一方の permissions または governance が通信を許可していません</translation>
    </message>
</context>
</TS>
