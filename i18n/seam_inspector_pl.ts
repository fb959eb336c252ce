<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1">
<context>
    <name>@default</name>
    <message>
        <location filename="../plugin/adapters/window_layer.py" line="173"/>
        <source>Inspect windows</source>
        <translation>Skontroluj okna</translation>
    </message>
    <message>
        <location filename="../plugin/processing/inspectwindows.py" line="50"/>
        <source>Measures how much local contrast a mosaic kept in each window. The mosaic and every source that covers the window are clipped and decomposed by wavelets; the share of the variance that each level of detail has in the mosaic is divided by its share in the source. At level 1, the finest, a ratio of 0.5 or less against every source is a significant loss, one below 1 reduced, else the detail is preserved (Pyka 2010).</source>
        <translation>Mierzy, ile kontrastu lokalnego zachowała ortofotomapa w każdym oknie. Wycinki ortofotomapy i wszystkich pokrywających okno ortoobrazów źródłowych są poddawane dekompozycji falkowej; wariancja względna detali ortofotomapy na każdym poziomie rozdzielczości jest dzielona przez wariancję względną detali ortoobrazu. Jeżeli na poziomie 1, najdokładniejszym, stosunek ten względem każdego ortoobrazu wynosi 0,5 lub mniej, strata jest istotna (significant); jeżeli jest mniejszy od 1, detale są osłabione (reduced); w pozostałych przypadkach są zachowane (preserved). Zob. Pyka 2010.</translation>
    </message>
    <message>
        <location filename="../plugin/adapters/window_layer.py" line="83"/>
        <source>Windows</source>
        <translation>Okna</translation>
    </message>
    <message>
        <location filename="../plugin/processing/inspectwindows.py" line="60"/>
        <source>Rectangles on the mosaic in any reference system, drawn or placed along the seamlines. What is measured is the rectangle around each, snapped to the mosaic&apos;s pixels.</source>
        <translation>Prostokąty na ortofotomapie, w dowolnym układzie współrzędnych, narysowane lub rozmieszczone wzdłuż linii mozaikowania. Pomiar obejmuje prostokąt opisany na każdym z nich, dociągnięty do siatki pikseli ortofotomapy.</translation>
    </message>
    <message>
        <location filename="../plugin/processing/inspectwindows.py" line="72"/>
        <source>Largest ratio of a significant loss</source>
        <translation>Największy stosunek wariancji przy istotnej stracie</translation>
    </message>
    <message>
        <location filename="../plugin/processing/inspectwindows.py" line="72"/>
        <source>A window is significant when its ratio at level 1 is this or less.</source>
        <translation>Okno otrzymuje ocenę significant, gdy jego stosunek wariancji na poziomie 1 nie przekracza tej wartości.</translation>
    </message>
    <message>
        <location filename="../plugin/processing/inspectwindows.py" line="84"/>
        <source>Dask scheduler</source>
        <translation>Scheduler Dask</translation>
    </message>
    <message>
        <location filename="../plugin/processing/inspectwindows.py" line="84"/>
        <source>Address of a Dask scheduler (tcp://host:8786) whose workers see the rasters under the same paths. Empty: all cores of this machine.</source>
        <translation>Adres schedulera Dask (tcp://host:8786), którego procesy robocze widzą rastry pod tymi samymi ścieżkami. Puste pole: wszystkie rdzenie tego komputera.</translation>
    </message>
    <message>
        <location filename="../plugin/processing/inspectwindows.py" line="92"/>
        <source>Inspected windows</source>
        <translation>Skontrolowane okna</translation>
    </message>
    <message>
        <location filename="../plugin/processing/inspectwindows.py" line="92"/>
        <source>The rectangles as measured, with their verdict and ratios: the largest over the sources.</source>
        <translation>Prostokąty w zmierzonych granicach, z oceną i ze stosunkami wariancji: największymi spośród wszystkich ortoobrazów źródłowych.</translation>
    </message>
    <message>
        <location filename="../plugin/processing/inspectwindows.py" line="96"/>
        <source>Curves</source>
        <translation>Krzywe</translation>
    </message>
    <message>
        <location filename="../plugin/processing/inspectwindows.py" line="96"/>
        <source>Relative variance of every component, for each window, raster and band.</source>
        <translation>Wariancja względna każdego komponentu, dla każdego okna, rastra i kanału.</translation>
    </message>
    <message>
        <location filename="../plugin/processing/inspectwindows.py" line="100"/>
        <source>Pairs</source>
        <translation>Pary</translation>
    </message>
    <message>
        <location filename="../plugin/processing/inspectwindows.py" line="100"/>
        <source>The mosaic against each single source: ratios, similarity, sub-pixel offset.</source>
        <translation>Ortofotomapa względem każdego ortoobrazu źródłowego z osobna: stosunki wariancji, podobieństwo, przesunięcie podpikselowe.</translation>
    </message>
    <message>
        <location filename="../plugin/processing/inspectwindows.py" line="105"/>
        <source>Windows with a significant loss</source>
        <translation>Okna z istotną stratą</translation>
    </message>
    <message>
        <location filename="../plugin/processing/inspectwindows.py" line="106"/>
        <source>Windows that can&apos;t be compared</source>
        <translation>Okna niedające się porównać</translation>
    </message>
    <message>
        <location filename="../plugin/processing/base.py" line="41"/>
        <source>Seam inspection</source>
        <translation>Kontrola linii mozaikowania</translation>
    </message>
    <message>
        <location filename="../plugin/processing/base.py" line="161"/>
        <source>A result can&apos;t be written; is the disk full?</source>
        <translation>Nie można zapisać wyniku; sprawdź, czy na dysku jest wolne miejsce.</translation>
    </message>
    <message>
        <location filename="../plugin/processing/parameters.py" line="33"/>
        <source>Mosaic</source>
        <translation>Ortofotomapa</translation>
    </message>
    <message>
        <location filename="../plugin/processing/parameters.py" line="33"/>
        <source>The orthophoto mosaic under inspection: north-up, with a coordinate reference system.</source>
        <translation>Kontrolowana ortofotomapa: zorientowana na północ, z określonym układem współrzędnych.</translation>
    </message>
    <message>
        <location filename="../plugin/processing/parameters.py" line="40"/>
        <source>Sources</source>
        <translation>Ortoobrazy źródłowe</translation>
    </message>
    <message>
        <location filename="../plugin/processing/parameters.py" line="40"/>
        <source>The orthoimages that the mosaic was made from. Each is clipped on its own pixel grid; one whose pixels differ in size by more than 1 %, or whose axes are not parallel, is resampled and marked so.</source>
        <translation>Ortoobrazy, z których powstała ortofotomapa. Każdy jest wycinany we własnej siatce pikseli; ortoobraz, którego piksel różni się wielkością o więcej niż 1% lub którego osie nie są równoległe do osi ortofotomapy, jest przepróbkowywany i odpowiednio oznaczany.</translation>
    </message>
    <message>
        <location filename="../plugin/processing/parameters.py" line="52"/>
        <source>Source index</source>
        <translation>Indeks ortoobrazów źródłowych</translation>
    </message>
    <message>
        <location filename="../plugin/processing/parameters.py" line="52"/>
        <source>A tile index of orthoimages as gdaltindex writes it, with their paths in the field &apos;location&apos;; relative paths start at the index file&apos;s folder. For blocks with too many sources to load, alone or beside them.</source>
        <translation>Indeks kafli ortoobrazów w postaci zapisywanej przez gdaltindex, ze ścieżkami w polu „location”; ścieżki względne liczą się od katalogu pliku indeksu. Przydatny dla bloków, w których ortoobrazów jest zbyt wiele, aby je wczytać; można go podać zamiast nich albo razem z nimi.</translation>
    </message>
    <message>
        <location filename="../plugin/processing/parameters.py" line="64"/>
        <source>Levels</source>
        <translation>Liczba poziomów rozdzielczości</translation>
    </message>
    <message>
        <location filename="../plugin/processing/parameters.py" line="64"/>
        <source>Steps of the decomposition. Level 1 holds the finest detail, each further one detail twice as coarse.</source>
        <translation>Liczba kroków dekompozycji. Poziom 1 zawiera najdrobniejsze detale, każdy następny – detale dwukrotnie grubsze.</translation>
    </message>
    <message>
        <location filename="../plugin/processing/parameters.py" line="78"/>
        <source>Wavelet</source>
        <translation>Falka</translation>
    </message>
    <message>
        <location filename="../plugin/processing/parameters.py" line="78"/>
        <source>An orthogonal wavelet of PyWavelets; the Coiflet of order 3 is the one of Pyka&apos;s papers.</source>
        <translation>Falka ortogonalna z biblioteki PyWavelets; w pracach Pyki stosowany jest coiflet rzędu 3.</translation>
    </message>
    <message>
        <location filename="../plugin/processing/placewindows.py" line="34"/>
        <source>Place windows along seamlines</source>
        <translation>Rozmieść okna wzdłuż linii mozaikowania</translation>
    </message>
    <message>
        <location filename="../plugin/processing/placewindows.py" line="35"/>
        <source>Places square windows of about 100 m along the seamlines of a mosaic, ready to be inspected. A window&apos;s side is the smallest power of two of pixels that spans the length asked for, and its edges are pixel edges of the mosaic. Windows that would stick out of the mosaic are moved along their seam; the log names those that had to be dropped.</source>
        <translation>Rozmieszcza wzdłuż linii mozaikowania ortofotomapy kwadratowe okna o boku około 100 m, gotowe do kontroli. Bok okna w pikselach jest najmniejszą potęgą liczby 2, która obejmuje zadaną długość, a krawędzie okna biegną po krawędziach pikseli ortofotomapy. Okna, które wystawałyby poza ortofotomapę, są przesuwane wzdłuż swojej linii mozaikowania; okna, które trzeba było pominąć, wymienia dziennik.</translation>
    </message>
    <message>
        <location filename="../plugin/processing/placewindows.py" line="45"/>
        <source>Seamlines</source>
        <translation>Linie mozaikowania</translation>
    </message>
    <message>
        <location filename="../plugin/processing/placewindows.py" line="45"/>
        <source>Lines, or polygons of which each is filled from one orthoimage: where two touch there is a seam. Fragments and pixel staircases are joined and straightened first.</source>
        <translation>Linie albo poligony, z których każdy jest wypełniony jednym ortoobrazem: linia mozaikowania biegnie tam, gdzie stykają się dwa poligony. Fragmenty linii są najpierw łączone, a przebiegi schodkowe (po krawędziach pikseli) prostowane.</translation>
    </message>
    <message>
        <location filename="../plugin/processing/placewindows.py" line="53"/>
        <source>Window side (metres)</source>
        <translation>Bok okna (metry)</translation>
    </message>
    <message>
        <location filename="../plugin/processing/placewindows.py" line="53"/>
        <source>What a window spans at least: 100 m at 0.10 m pixels gives 1024 pixels, 102.4 m.</source>
        <translation>Najmniejsza dopuszczalna długość boku okna: 100 m przy pikselu 0,10 m daje 1024 piksele, czyli 102,4 m.</translation>
    </message>
    <message>
        <location filename="../plugin/processing/placewindows.py" line="57"/>
        <source>Spacing (metres)</source>
        <translation>Odstęp okien (metry)</translation>
    </message>
    <message>
        <location filename="../plugin/processing/placewindows.py" line="57"/>
        <source>Distance between the centres of neighbouring windows, measured along the seam.</source>
        <translation>Odległość między środkami sąsiednich okien, mierzona wzdłuż linii mozaikowania.</translation>
    </message>
    <message>
        <location filename="../plugin/processing/placewindows.py" line="62"/>
        <source>The windows, with the number of their seam and their station along it in metres.</source>
        <translation>Okna z numerem linii mozaikowania i pikietażem wzdłuż niej w metrach.</translation>
    </message>
    <message>
        <location filename="../plugin/processing/placewindows.py" line="109"/>
        <source>{windows} windows placed along {seams} seams.</source>
        <translation>Liczba rozmieszczonych okien: {windows}, liczba linii mozaikowania: {seams}.</translation>
    </message>
    <message>
        <location filename="../plugin/core/messages.py" line="44"/>
        <source>The window side is {side} m; give a positive number of metres.</source>
        <translation>Bok okna wynosi {side} m; podaj dodatnią liczbę metrów.</translation>
    </message>
    <message>
        <location filename="../plugin/core/messages.py" line="45"/>
        <source>The window lies outside the mosaic; draw it on the mosaic.</source>
        <translation>Okno leży poza ortofotomapą; narysuj je na ortofotomapie.</translation>
    </message>
    <message>
        <location filename="../plugin/core/messages.py" line="46"/>
        <source>The window covers {width} x {height} px of the mosaic; a side needs at least {fewest} px, so draw it larger.</source>
        <translation>Okno obejmuje {width} × {height} px ortofotomapy, a bok musi mieć co najmniej {fewest} px; narysuj większe okno.</translation>
    </message>
    <message>
        <location filename="../plugin/core/messages.py" line="49"/>
        <source>{levels} levels need a window of at least {fewest} px a side and this one has {width} x {height} px; use fewer levels or draw it larger.</source>
        <translation>Liczba poziomów równa {levels} wymaga okna o boku co najmniej {fewest} px, a to okno ma {width} × {height} px; zmniejsz liczbę poziomów albo narysuj większe okno.</translation>
    </message>
    <message>
        <location filename="../plugin/core/messages.py" line="54"/>
        <source>PyWavelets has no discrete wavelet &apos;{wavelet}&apos;; use an orthogonal one such as coif3.</source>
        <translation>Biblioteka PyWavelets nie zawiera falki dyskretnej „{wavelet}”; użyj falki ortogonalnej, np. coif3.</translation>
    </message>
    <message>
        <location filename="../plugin/core/messages.py" line="55"/>
        <source>The wavelet &apos;{wavelet}&apos; is not orthogonal, so the shares of its components do not add up to the clip&apos;s variance; use an orthogonal one such as coif3, db4 or sym8.</source>
        <translation>Falka „{wavelet}” nie jest ortogonalna, więc udziały jej komponentów nie sumują się do wariancji wycinka; użyj falki ortogonalnej, np. coif3, db4 lub sym8.</translation>
    </message>
    <message>
        <location filename="../plugin/core/messages.py" line="59"/>
        <source>{levels} levels asked for; the decomposition has {least} to {most}.</source>
        <translation>Podano liczbę poziomów {levels}, a dekompozycja może ich mieć od {least} do {most}; podaj liczbę z tego zakresu.</translation>
    </message>
    <message>
        <location filename="../plugin/core/messages.py" line="61"/>
        <source>The seamline layer is empty; choose a layer with lines or polygons of the mosaic&apos;s seams.</source>
        <translation>Warstwa linii mozaikowania jest pusta; wybierz warstwę z liniami lub poligonami, które wyznaczają linie mozaikowania ortofotomapy.</translation>
    </message>
    <message>
        <location filename="../plugin/core/messages.py" line="62"/>
        <source>The seamline layer holds no line and no polygon; choose the layer of the mosaic&apos;s seamlines or of its source polygons.</source>
        <translation>Warstwa linii mozaikowania nie zawiera linii ani poligonów; wybierz warstwę linii mozaikowania ortofotomapy albo poligonów jej ortoobrazów źródłowych.</translation>
    </message>
    <message>
        <location filename="../plugin/core/messages.py" line="66"/>
        <source>No two polygons of the seamline layer share a border; snap them to each other (gaps and overlaps up to half a pixel are bridged), or give the seams as lines.</source>
        <translation>Żadne dwa poligony warstwy linii mozaikowania nie mają wspólnej granicy; dociągnij je do siebie (szczeliny i nakładki do pół piksela są tolerowane) albo podaj linie mozaikowania jako linie.</translation>
    </message>
    <message>
        <location filename="../plugin/core/messages.py" line="70"/>
        <source>The lines of the seamline layer are shorter than a pixel of the mosaic; check the reference systems of both.</source>
        <translation>Linie w warstwie linii mozaikowania są krótsze niż piksel ortofotomapy; sprawdź układy współrzędnych warstwy i ortofotomapy.</translation>
    </message>
    <message>
        <location filename="../plugin/core/messages.py" line="73"/>
        <source>The seamline layer spans {width} x {height} px of the mosaic; check the reference systems of both.</source>
        <translation>Warstwa linii mozaikowania rozciąga się na {width} × {height} px ortofotomapy; sprawdź układy współrzędnych warstwy i ortofotomapy.</translation>
    </message>
    <message>
        <location filename="../plugin/core/messages.py" line="76"/>
        <source>The geometry of feature {feature} in the seamline layer can&apos;t be read; repair the layer with &apos;Fix geometries&apos;.</source>
        <translation>Nie można odczytać geometrii obiektu {feature} w warstwie linii mozaikowania; napraw warstwę algorytmem „Napraw geometrie”.</translation>
    </message>
    <message>
        <location filename="../plugin/core/messages.py" line="79"/>
        <source>The seamline layer holds coordinates that are no numbers; repair it with &apos;Fix geometries&apos;.</source>
        <translation>Warstwa linii mozaikowania zawiera współrzędne, które nie są liczbami; napraw ją algorytmem „Napraw geometrie”.</translation>
    </message>
    <message>
        <location filename="../plugin/core/messages.py" line="82"/>
        <source>The spacing is {spacing} m; give a positive number of metres.</source>
        <translation>Odstęp okien wynosi {spacing} m; podaj dodatnią liczbę metrów.</translation>
    </message>
    <message>
        <location filename="../plugin/core/messages.py" line="83"/>
        <source>A window of {side} m has {pixels} px a side on this mosaic and {levels} levels need at least {fewest} px; give a side of {metres} m or more.</source>
        <translation>Okno o boku {side} m ma na tej ortofotomapie bok {pixels} px, a liczba poziomów równa {levels} wymaga co najmniej {fewest} px; podaj bok {metres} m lub większy.</translation>
    </message>
    <message>
        <location filename="../plugin/core/messages.py" line="87"/>
        <source>The mosaic is {width:.1f} x {height:.1f} m, too small for a window of {side:.1f} m; give a shorter side.</source>
        <translation>Ortofotomapa ma {width:.1f} × {height:.1f} m i jest za mała na okno o boku {side:.1f} m; podaj krótszy bok.</translation>
    </message>
    <message>
        <location filename="../plugin/core/messages.py" line="90"/>
        <source>Seam {seam} has no window at {station:.1f} m: it would stick out of the mosaic or hold too few valid pixels, and there is no room beside.</source>
        <translation>Linia mozaikowania {seam} nie ma okna na {station:.1f} m: wystawałoby poza ortofotomapę lub zawierało zbyt mało pikseli z danymi, a obok nie ma miejsca.</translation>
    </message>
    <message>
        <location filename="../plugin/core/messages.py" line="94"/>
        <source>Seam {seam} has no windows from {start:.1f} to {end:.1f} m: they would stick out of the mosaic or hold too few valid pixels, and there is no room beside.</source>
        <translation>Linia mozaikowania {seam} nie ma okien od {start:.1f} do {end:.1f} m: wystawałyby poza ortofotomapę lub zawierały zbyt mało pikseli z danymi, a obok nie ma miejsca.</translation>
    </message>
    <message>
        <location filename="../plugin/core/messages.py" line="98"/>
        <source>Left out because they would share more than half of their pixels with another window of the same seam: {count}.</source>
        <translation>Okna pominięte, ponieważ miałyby ponad połowę pikseli wspólnych z innym oknem tej samej linii mozaikowania: {count}.</translation>
    </message>
    <message>
        <location filename="../plugin/core/messages.py" line="101"/>
        <source>Seams that lie within windows of longer ones and got none of their own: {count}.</source>
        <translation>Linie mozaikowania leżące w oknach dłuższych linii, bez własnych okien: {count}.</translation>
    </message>
    <message>
        <location filename="../plugin/core/messages.py" line="102"/>
        <source>Seams shorter than {shortest:.2f} m, too short to matter in a window: {count}.</source>
        <translation>Linie mozaikowania krótsze niż {shortest:.2f} m, zbyt krótkie, aby miały znaczenie w oknie: {count}.</translation>
    </message>
    <message>
        <location filename="../plugin/core/messages.py" line="103"/>
        <source>Seams outside the mosaic: {count}.</source>
        <translation>Linie mozaikowania poza ortofotomapą: {count}.</translation>
    </message>
    <message>
        <location filename="../plugin/core/messages.py" line="105"/>
        <source>{path} does not exist; check the path.</source>
        <translation>{path} nie istnieje; sprawdź ścieżkę.</translation>
    </message>
    <message>
        <location filename="../plugin/core/messages.py" line="106"/>
        <source>{name} is not a raster that GDAL can read; check that the file is complete.</source>
        <translation>{name} nie jest rastrem, który GDAL potrafi odczytać; sprawdź, czy plik jest kompletny.</translation>
    </message>
    <message>
        <location filename="../plugin/core/messages.py" line="107"/>
        <source>The pixels of {name} can&apos;t be read; the file may be truncated or damaged, so copy it anew.</source>
        <translation>Nie można odczytać pikseli rastra {name}; plik może być niepełny lub uszkodzony, więc skopiuj go ponownie.</translation>
    </message>
    <message>
        <location filename="../plugin/core/messages.py" line="108"/>
        <source>{name} has no bands of its own; choose one of its subdatasets.</source>
        <translation>Raster {name} nie ma własnych kanałów; wybierz jeden z jego podzbiorów danych (subdatasets).</translation>
    </message>
    <message>
        <location filename="../plugin/core/messages.py" line="109"/>
        <source>{name} holds complex values; convert them to magnitudes first.</source>
        <translation>Raster {name} zawiera wartości zespolone; najpierw zamień je na moduły.</translation>
    </message>
    <message>
        <location filename="../plugin/core/messages.py" line="110"/>
        <source>{name} has no position on the map; georeference or orthorectify it first.</source>
        <translation>Raster {name} nie ma położenia na mapie; najpierw nadaj mu georeferencję lub wykonaj ortorektyfikację.</translation>
    </message>
    <message>
        <location filename="../plugin/core/messages.py" line="111"/>
        <source>{name} has no coordinate reference system; set it in the layer&apos;s properties or write it into the file.</source>
        <translation>Raster {name} nie ma układu współrzędnych; ustaw go we właściwościach warstwy albo zapisz w pliku.</translation>
    </message>
    <message>
        <location filename="../plugin/core/messages.py" line="114"/>
        <source>{name} is rotated, mirrored or south-up; warp it to a north-up grid first.</source>
        <translation>Raster {name} jest obrócony, odbity lustrzanie lub zorientowany na południe; najpierw przepróbkuj go do siatki pikseli zorientowanej na północ.</translation>
    </message>
    <message>
        <location filename="../plugin/core/messages.py" line="115"/>
        <source>{name} does not cover the whole window.</source>
        <translation>Raster {name} nie pokrywa całego okna.</translation>
    </message>
    <message>
        <location filename="../plugin/core/messages.py" line="116"/>
        <source>{share:.2%} of the pixels of {name} are invalid in the window and {most:.1%} are allowed; move the window.</source>
        <translation>Udział pikseli bez danych w oknie wynosi w rastrze {name} {share:.2%}, a dopuszczalne jest {most:.1%}; przesuń okno.</translation>
    </message>
    <message>
        <location filename="../plugin/core/messages.py" line="119"/>
        <source>An extent can&apos;t be transformed to the mosaic&apos;s coordinate reference system; check the layers&apos; systems.</source>
        <translation>Nie można przeliczyć zasięgu do układu współrzędnych ortofotomapy; sprawdź układy współrzędnych warstw.</translation>
    </message>
    <message>
        <location filename="../plugin/core/messages.py" line="123"/>
        <source>The largest ratio of a significant loss is {ratio}; give a number between 0 and 1.</source>
        <translation>Największy stosunek wariancji przy istotnej stracie wynosi {ratio}; podaj liczbę od 0 do 1.</translation>
    </message>
    <message>
        <location filename="../plugin/core/messages.py" line="124"/>
        <source>No sources are given; choose the orthoimages the mosaic was made from, or their index layer.</source>
        <translation>Nie podano ortoobrazów źródłowych; wybierz ortoobrazy, z których powstała ortofotomapa, albo warstwę ich indeksu.</translation>
    </message>
    <message>
        <location filename="../plugin/core/messages.py" line="127"/>
        <source>{name} is the mosaic itself and is left out of the sources.</source>
        <translation>Raster {name} to sama ortofotomapa, więc nie zalicza się do ortoobrazów źródłowych.</translation>
    </message>
    <message>
        <location filename="../plugin/core/messages.py" line="128"/>
        <source>{name} is left out: {why}</source>
        <translation>Pominięto raster {name}: {why}</translation>
    </message>
    <message>
        <location filename="../plugin/core/messages.py" line="129"/>
        <source>No source covers the window; add the orthoimages that overlap it or move the window.</source>
        <translation>Żaden ortoobraz źródłowy nie pokrywa okna; dodaj ortoobrazy z tego miejsca albo przesuń okno.</translation>
    </message>
    <message>
        <location filename="../plugin/core/messages.py" line="130"/>
        <source>No source can be compared here: {why}</source>
        <translation>Żadnego ortoobrazu źródłowego nie można tu porównać: {why}</translation>
    </message>
    <message>
        <location filename="../plugin/core/messages.py" line="131"/>
        <source>The mosaic has no variance in the window; move the window to where there is content.</source>
        <translation>Ortofotomapa ma w oknie zerową wariancję; przesuń okno tam, gdzie jest treść.</translation>
    </message>
    <message>
        <location filename="../plugin/core/messages.py" line="132"/>
        <source>{name} has no variance in the window; move the window to where there is content.</source>
        <translation>Raster {name} ma w oknie zerową wariancję; przesuń okno tam, gdzie jest treść.</translation>
    </message>
    <message>
        <location filename="../plugin/core/messages.py" line="133"/>
        <source>No source has detail at level 1 in the window; move the window to where there is some.</source>
        <translation>Żaden ortoobraz źródłowy nie ma w oknie detali na poziomie 1; przesuń okno tam, gdzie są detale.</translation>
    </message>
    <message>
        <location filename="../plugin/core/messages.py" line="136"/>
        <source>{name} has no {band} (its bands: {bands}); choose sources with the mosaic&apos;s bands.</source>
        <translation>Raster {name} nie ma kanału {band} (jego kanały: {bands}); wybierz ortoobrazy źródłowe o takich samych kanałach jak ortofotomapa.</translation>
    </message>
    <message>
        <location filename="../plugin/core/messages.py" line="137"/>
        <source>The window covers {width} x {height} px of the mosaic and {most} million px are the most; draw it smaller.</source>
        <translation>Okno obejmuje {width} × {height} px ortofotomapy, a może mieć najwyżej {most} mln px; narysuj mniejsze okno.</translation>
    </message>
    <message>
        <location filename="../plugin/core/messages.py" line="140"/>
        <source>The window could not be measured ({error}); please report this.</source>
        <translation>Nie udało się zmierzyć okna ({error}); zgłoś ten błąd.</translation>
    </message>
    <message>
        <location filename="../plugin/core/messages.py" line="142"/>
        <source>{name} is not a raster layer; choose a raster.</source>
        <translation>{name} nie jest warstwą rastrową; wybierz raster.</translation>
    </message>
    <message>
        <location filename="../plugin/core/messages.py" line="143"/>
        <source>{name} is not a file that GDAL reads but comes from a service; choose the raster file itself.</source>
        <translation>{name} nie jest plikiem odczytywanym przez GDAL, lecz pochodzi z usługi sieciowej; wybierz sam plik rastra.</translation>
    </message>
    <message>
        <location filename="../plugin/core/messages.py" line="144"/>
        <source>The window has no outline; draw it anew.</source>
        <translation>Okno nie ma obrysu; narysuj je od nowa.</translation>
    </message>
    <message>
        <location filename="../plugin/core/messages.py" line="145"/>
        <source>The window is not a polygon; draw it as a rectangle.</source>
        <translation>Okno nie jest poligonem; narysuj je jako prostokąt.</translation>
    </message>
    <message>
        <location filename="../plugin/core/messages.py" line="146"/>
        <source>The window has several parts; split it into one window each.</source>
        <translation>Okno składa się z kilku części; podziel je tak, aby każda część była osobnym oknem.</translation>
    </message>
    <message>
        <location filename="../plugin/core/messages.py" line="147"/>
        <source>The outline of the window crosses itself; draw it anew as a rectangle.</source>
        <translation>Obrys okna przecina sam siebie; narysuj okno od nowa jako prostokąt.</translation>
    </message>
    <message>
        <location filename="../plugin/core/messages.py" line="148"/>
        <source>The window layer is empty; draw windows or place them along the seamlines first.</source>
        <translation>Warstwa okien jest pusta; najpierw narysuj okna albo rozmieść je wzdłuż linii mozaikowania.</translation>
    </message>
    <message>
        <location filename="../plugin/core/messages.py" line="149"/>
        <source>The index layer has no field &apos;{field}&apos;; make it with gdaltindex.</source>
        <translation>Warstwa indeksu nie ma pola „{field}”; utwórz ją poleceniem gdaltindex.</translation>
    </message>
    <message>
        <location filename="../plugin/core/messages.py" line="150"/>
        <source>{count} windows had no number of their own and were given the next free ones.</source>
        <translation>Okna bez własnego numeru otrzymały kolejne wolne numery; liczba takich okien: {count}.</translation>
    </message>
    <message>
        <location filename="../plugin/core/messages.py" line="151"/>
        <source>A Dask scheduler was given but Dask is not installed; install &apos;dask[distributed]&apos; or leave the scheduler empty.</source>
        <translation>Podano scheduler Dask, ale pakiet Dask nie jest zainstalowany; zainstaluj „dask[distributed]” albo pozostaw pole schedulera puste.</translation>
    </message>
    <message>
        <location filename="../plugin/core/messages.py" line="154"/>
        <source>The Dask scheduler at {address} does not answer ({error}); check the address or leave it empty.</source>
        <translation>Scheduler Dask pod adresem {address} nie odpowiada ({error}); sprawdź adres albo pozostaw pole puste.</translation>
    </message>
    <message>
        <location filename="../plugin/core/messages.py" line="157"/>
        <source>The Dask scheduler at {address} has no workers; start some or leave it empty.</source>
        <translation>Scheduler Dask pod adresem {address} nie ma procesów roboczych; uruchom je albo pozostaw pole puste.</translation>
    </message>
    <message>
        <location filename="../plugin/adapters/charts.py" line="119"/>
        <source>significant loss below</source>
        <translation>istotna strata poniżej</translation>
    </message>
    <message>
        <location filename="../plugin/adapters/charts.py" line="107"/>
        <source>background</source>
        <translation>tło</translation>
    </message>
    <message>
        <location filename="../plugin/adapters/charts.py" line="95"/>
        <source>level</source>
        <translation>poziom rozdzielczości</translation>
    </message>
    <message>
        <location filename="../plugin/adapters/charts.py" line="96"/>
        <source>relative variance</source>
        <translation>wariancja względna</translation>
    </message>
    <message>
        <location filename="../plugin/gui/dock.py" line="273"/>
        <source>Seam Inspector</source>
        <translation>Seam Inspector</translation>
    </message>
    <message>
        <location filename="../plugin/plugin.py" line="42"/>
        <source>Inspect how much detail a mosaic kept along its seams</source>
        <translation>Kontrola zachowania detali ortofotomapy wzdłuż linii mozaikowania</translation>
    </message>
    <message>
        <location filename="../plugin/gui/window_pictures.py" line="47"/>
        <source>Read pictures</source>
        <translation>Wczytaj obrazy</translation>
    </message>
    <message>
        <location filename="../plugin/gui/curves_legend.py" line="41"/>
        <source>Click an entry to hide its curve or to show it again; right click for more</source>
        <translation>Kliknij pozycję, aby ukryć lub pokazać jej krzywą; prawy przycisk myszy: więcej opcji</translation>
    </message>
    <message>
        <location filename="../plugin/gui/curves_legend.py" line="77"/>
        <source>limit</source>
        <translation>granica</translation>
    </message>
    <message>
        <location filename="../plugin/gui/curves_legend.py" line="78"/>
        <source>On or below this line the mosaic has lost significantly against the least sharp source</source>
        <translation>Na tej linii lub poniżej strata ortofotomapy względem najmniej ostrego ortoobrazu źródłowego jest istotna</translation>
    </message>
    <message>
        <location filename="../plugin/gui/curves_legend.py" line="119"/>
        <source>Click to show this curve</source>
        <translation>Kliknij, aby pokazać tę krzywą</translation>
    </message>
    <message>
        <location filename="../plugin/gui/curves_legend.py" line="119"/>
        <source>Click to hide this curve</source>
        <translation>Kliknij, aby ukryć tę krzywą</translation>
    </message>
    <message>
        <location filename="../plugin/gui/curves_legend.py" line="153"/>
        <source>Show only this source</source>
        <translation>Pokaż tylko ten ortoobraz</translation>
    </message>
    <message>
        <location filename="../plugin/gui/curves_legend.py" line="154"/>
        <source>Show all curves</source>
        <translation>Pokaż wszystkie krzywe</translation>
    </message>
    <message>
        <location filename="../plugin/gui/picture_title.py" line="24"/>
        <source>mosaic</source>
        <translation>ortofotomapa</translation>
    </message>
    <message>
        <location filename="../plugin/gui/picture_title.py" line="24"/>
        <source>source</source>
        <translation>źródło</translation>
    </message>
    <message>
        <location filename="../plugin/gui/verdicts.py" line="32"/>
        <source>significant</source>
        <translation>istotna strata</translation>
    </message>
    <message>
        <location filename="../plugin/gui/verdicts.py" line="33"/>
        <source>reduced</source>
        <translation>osłabione</translation>
    </message>
    <message>
        <location filename="../plugin/gui/verdicts.py" line="34"/>
        <source>preserved</source>
        <translation>zachowane</translation>
    </message>
    <message>
        <location filename="../plugin/gui/verdicts.py" line="35"/>
        <source>not comparable</source>
        <translation>nieporównywalne</translation>
    </message>
    <message>
        <location filename="../plugin/gui/verdicts.py" line="36"/>
        <source>not inspected</source>
        <translation>nieskontrolowane</translation>
    </message>
    <message>
        <location filename="../plugin/gui/verdicts.py" line="42"/>
        <source>visible</source>
        <translation>widoczna</translation>
    </message>
    <message>
        <location filename="../plugin/gui/verdicts.py" line="42"/>
        <source>invisible</source>
        <translation>niewidoczna</translation>
    </message>
    <message>
        <location filename="../plugin/gui/verdicts.py" line="61"/>
        <source>Not inspected yet.</source>
        <translation>Okno nie było jeszcze kontrolowane.</translation>
    </message>
    <message>
        <location filename="../plugin/gui/verdicts.py" line="63"/>
        <source>The mosaic could not be compared with a source here.</source>
        <translation>Ortofotomapy nie udało się tu porównać z żadnym ortoobrazem źródłowym.</translation>
    </message>
    <message>
        <location filename="../plugin/gui/verdicts.py" line="66"/>
        <source>{finding} Changed since: inspect it again.</source>
        <translation>{finding} Od tego czasu nastąpiły zmiany: skontroluj okno ponownie.</translation>
    </message>
    <message>
        <location filename="../plugin/gui/verdicts.py" line="76"/>
        <source>{count} changed since</source>
        <translation>zmienione od kontroli: {count}</translation>
    </message>
    <message>
        <location filename="../plugin/gui/verdicts.py" line="77"/>
        <source>{count} windows selected: {verdicts}.</source>
        <translation>Liczba zaznaczonych okien: {count} ({verdicts}).</translation>
    </message>
    <message>
        <location filename="../plugin/gui/verdicts.py" line="104"/>
        <source>Detail at level 1 is {percent} % of the source&apos;s: {verdict}.</source>
        <translation>Detale na poziomie 1 to {percent}% detali ortoobrazu źródłowego: {verdict}.</translation>
    </message>
    <message>
        <location filename="../plugin/gui/verdicts.py" line="106"/>
        <source>Detail at level 1 is {percent} % of the least sharp source&apos;s: {verdict}.</source>
        <translation>Detale na poziomie 1 to {percent}% detali najmniej ostrego ortoobrazu źródłowego: {verdict}.</translation>
    </message>
    <message>
        <location filename="../plugin/gui/verdicts.py" line="107"/>
        <source>significant loss</source>
        <translation>istotna strata</translation>
    </message>
    <message>
        <location filename="../plugin/gui/inputs_panel.py" line="161"/>
        <source>Inputs: choose the mosaic</source>
        <translation>Dane wejściowe: wybierz ortofotomapę</translation>
    </message>
    <message>
        <location filename="../plugin/gui/window_tool.py" line="256"/>
        <source>1 source</source>
        <translation>1 źródło</translation>
    </message>
    <message>
        <location filename="../plugin/gui/window_tool.py" line="257"/>
        <source>{count} sources</source>
        <translation>źródła: {count}</translation>
    </message>
    <message>
        <location filename="../plugin/gui/inputs_panel.py" line="165"/>
        <source>{count} missing</source>
        <translation>brakujące: {count}</translation>
    </message>
    <message>
        <location filename="../plugin/gui/inputs_panel.py" line="167"/>
        <source>source index</source>
        <translation>indeks źródeł</translation>
    </message>
    <message>
        <location filename="../plugin/gui/inputs_panel.py" line="169"/>
        <source>seamlines</source>
        <translation>linie mozaikowania</translation>
    </message>
    <message>
        <location filename="../plugin/gui/inputs_panel.py" line="179"/>
        <source>{pixels} px, {metres:.1f} m</source>
        <translation>{pixels} px, {metres:.1f} m</translation>
    </message>
    <message>
        <location filename="../plugin/gui/inputs_panel.py" line="182"/>
        <source>The smallest power of two of the mosaic&apos;s pixels that spans at least the given metres</source>
        <translation>Najmniejsza potęga liczby 2 pikseli ortofotomapy, która obejmuje co najmniej podaną liczbę metrów</translation>
    </message>
    <message>
        <location filename="../plugin/gui/inputs_panel.py" line="184"/>
        <source>too short</source>
        <translation>za krótki</translation>
    </message>
    <message>
        <location filename="../plugin/gui/inputs_panel.py" line="190"/>
        <source>choose the mosaic</source>
        <translation>wybierz ortofotomapę</translation>
    </message>
    <message>
        <location filename="../plugin/gui/inputs_panel.py" line="192"/>
        <source>The orthophoto mosaic under inspection: north-up, a file that GDAL reads</source>
        <translation>Kontrolowana ortofotomapa: zorientowana na północ, w pliku odczytywanym przez GDAL</translation>
    </message>
    <message>
        <location filename="../plugin/gui/source_list.py" line="55"/>
        <source>none</source>
        <translation>brak</translation>
    </message>
    <message>
        <location filename="../plugin/gui/inputs_panel.py" line="195"/>
        <source>A tile index of orthoimages as gdaltindex writes it, for blocks with too many sources to load: polygons with the field &apos;location&apos;</source>
        <translation>Indeks kafli ortoobrazów w postaci zapisywanej przez gdaltindex, dla bloków, w których ortoobrazów jest zbyt wiele, aby je wczytać: poligony z polem „location”</translation>
    </message>
    <message>
        <location filename="../plugin/gui/inputs_panel.py" line="200"/>
        <source>The mosaic&apos;s seams, or the polygons of its sources: windows are placed along them, and a click near one is moved onto it</source>
        <translation>Linie mozaikowania ortofotomapy albo poligony jej ortoobrazów źródłowych: wzdłuż nich rozmieszczane są okna, a kliknięcie w pobliżu linii jest na nią przesuwane</translation>
    </message>
    <message>
        <location filename="../plugin/gui/inputs_panel.py" line="204"/>
        <source>new layer</source>
        <translation>nowa warstwa</translation>
    </message>
    <message>
        <location filename="../plugin/gui/inputs_panel.py" line="205"/>
        <source>The polygon layer that holds the windows; a new one is made with the first window</source>
        <translation>Warstwa poligonowa z oknami; nowa powstaje wraz z pierwszym oknem</translation>
    </message>
    <message>
        <location filename="../plugin/gui/inputs_panel.py" line="207"/>
        <source>Metres that a clicked or placed window spans at least</source>
        <translation>Najmniejsza długość boku klikniętego lub rozmieszczonego okna w metrach</translation>
    </message>
    <message>
        <location filename="../plugin/gui/inputs_panel.py" line="224"/>
        <source>&amp;Mosaic</source>
        <translation>&amp;Ortofotomapa</translation>
    </message>
    <message>
        <location filename="../plugin/gui/inputs_panel.py" line="225"/>
        <source>Source &amp;index</source>
        <translation>&amp;Indeks źródeł</translation>
    </message>
    <message>
        <location filename="../plugin/gui/inputs_panel.py" line="226"/>
        <source>Seam&amp;lines</source>
        <translation>&amp;Linie mozaikowania</translation>
    </message>
    <message>
        <location filename="../plugin/gui/inputs_panel.py" line="227"/>
        <source>&amp;Windows</source>
        <translation>O&amp;kna</translation>
    </message>
    <message>
        <location filename="../plugin/gui/inputs_panel.py" line="228"/>
        <source>Window si&amp;de</source>
        <translation>&amp;Bok okna</translation>
    </message>
    <message>
        <location filename="../plugin/gui/source_list.py" line="184"/>
        <source>missing: {name}</source>
        <translation>brak: {name}</translation>
    </message>
    <message>
        <location filename="../plugin/gui/layer_box.py" line="50"/>
        <source>can&apos;t be used: {name}</source>
        <translation>nie można użyć: {name}</translation>
    </message>
    <message>
        <location filename="../plugin/gui/windows_model.py" line="64"/>
        <source>{verdict}, changed</source>
        <translation>{verdict}, zmienione</translation>
    </message>
    <message>
        <location filename="../plugin/gui/curves_selection.py" line="28"/>
        <source>{count} of the {selected} selected windows: mean and range</source>
        <translation>Zaznaczone okna: {count} z {selected}, średnia i zakres</translation>
    </message>
    <message>
        <location filename="../plugin/gui/curves_selection.py" line="31"/>
        <source>{count} windows: mean and range</source>
        <translation>Liczba okien: {count}, średnia i zakres</translation>
    </message>
    <message>
        <location filename="../plugin/gui/images_panel.py" line="187"/>
        <source>Window {number}</source>
        <translation>Okno {number}</translation>
    </message>
    <message>
        <location filename="../plugin/gui/curves_selection.py" line="35"/>
        <source>, out of date: inspect it again</source>
        <translation>, nieaktualne: skontroluj je ponownie</translation>
    </message>
    <message>
        <location filename="../plugin/gui/curves_selection.py" line="41"/>
        <source>Select a window in the table or on the map, or draw one.</source>
        <translation>Zaznacz okno w tabeli lub na mapie albo je narysuj.</translation>
    </message>
    <message>
        <location filename="../plugin/gui/curves_selection.py" line="43"/>
        <source>None of the selected windows can be compared.</source>
        <translation>Żadnego z zaznaczonych okien nie można porównać.</translation>
    </message>
    <message>
        <location filename="../plugin/gui/curves_selection.py" line="46"/>
        <source>This window can&apos;t be compared.</source>
        <translation>Tego okna nie można porównać.</translation>
    </message>
    <message>
        <location filename="../plugin/gui/curves_selection.py" line="48"/>
        <source>Measuring ...</source>
        <translation>Pomiar...</translation>
    </message>
    <message>
        <location filename="../plugin/gui/curves_selection.py" line="53"/>
        <source>The curves are not kept with the project. Inspect again to see them.</source>
        <translation>Krzywe nie są zapisywane w projekcie. Aby je zobaczyć, skontroluj okno ponownie.</translation>
    </message>
    <message>
        <location filename="../plugin/gui/curves_selection.py" line="54"/>
        <source>Not inspected yet</source>
        <translation>Jeszcze nieskontrolowane</translation>
    </message>
    <message>
        <location filename="../plugin/gui/judge_bar.py" line="39"/>
        <source>Visible (V)</source>
        <translation>Widoczna (V)</translation>
    </message>
    <message>
        <location filename="../plugin/gui/judge_bar.py" line="39"/>
        <source>The loss of detail can be seen at 2x magnification. Click again to take it back.</source>
        <translation>Strata detali jest widoczna w powiększeniu 2×. Ponowne kliknięcie wycofuje opinię.</translation>
    </message>
    <message>
        <location filename="../plugin/gui/judge_bar.py" line="43"/>
        <source>Invisible (I)</source>
        <translation>Niewidoczna (I)</translation>
    </message>
    <message>
        <location filename="../plugin/gui/judge_bar.py" line="43"/>
        <source>The loss of detail can&apos;t be seen at 2x magnification. Click again to take it back.</source>
        <translation>Strata detali nie jest widoczna w powiększeniu 2×. Ponowne kliknięcie wycofuje opinię.</translation>
    </message>
    <message>
        <location filename="../plugin/gui/judge_bar.py" line="49"/>
        <source>Next (N)</source>
        <translation>Dalej (N)</translation>
    </message>
    <message>
        <location filename="../plugin/gui/judge_bar.py" line="49"/>
        <source>Selects the next compared window that is not judged yet.</source>
        <translation>Zaznacza następne porównane okno bez opinii obserwatora.</translation>
    </message>
    <message>
        <location filename="../plugin/gui/judge_bar.py" line="52"/>
        <source>Selects the window before this one.</source>
        <translation>Zaznacza poprzednie okno.</translation>
    </message>
    <message>
        <location filename="../plugin/gui/judge_bar.py" line="55"/>
        <source>Selects the window after this one.</source>
        <translation>Zaznacza następne okno.</translation>
    </message>
    <message>
        <location filename="../plugin/gui/windows_panel.py" line="233"/>
        <source>Judge visible</source>
        <translation>Strata widoczna</translation>
    </message>
    <message>
        <location filename="../plugin/gui/windows_panel.py" line="233"/>
        <source>Judge invisible</source>
        <translation>Strata niewidoczna</translation>
    </message>
    <message>
        <location filename="../plugin/gui/judge_bar.py" line="59"/>
        <source>Next window to judge</source>
        <translation>Następne okno bez opinii</translation>
    </message>
    <message>
        <location filename="../plugin/gui/judge_bar.py" line="91"/>
        <source>{judged} of {count} compared windows are judged.</source>
        <translation>Porównane okna z opinią obserwatora: {judged} z {count}.</translation>
    </message>
    <message>
        <location filename="../plugin/gui/judge_bar.py" line="175"/>
        <source>Select a window to judge it.</source>
        <translation>Zaznacz okno, aby wydać opinię.</translation>
    </message>
    <message>
        <location filename="../plugin/gui/judge_bar.py" line="181"/>
        <source>{place} of {count}</source>
        <translation>{place} z {count}</translation>
    </message>
    <message>
        <location filename="../plugin/gui/windows_panel.py" line="53"/>
        <source>Double click zooms to a window; Del removes the selected ones.</source>
        <translation>Dwukrotne kliknięcie powiększa do okna; klawisz Del usuwa zaznaczone okna.</translation>
    </message>
    <message>
        <location filename="../plugin/gui/windows_panel.py" line="152"/>
        <source>{shown} of {count}</source>
        <translation>{shown} z {count}</translation>
    </message>
    <message>
        <location filename="../plugin/gui/windows_panel.py" line="153"/>
        <source>No window matches the filter.</source>
        <translation>Żadne okno nie pasuje do filtra.</translation>
    </message>
    <message>
        <location filename="../plugin/gui/windows_panel.py" line="153"/>
        <source>Draw a window on the map, or place windows along the seamlines.</source>
        <translation>Narysuj okno na mapie albo rozmieść okna wzdłuż linii mozaikowania.</translation>
    </message>
    <message>
        <location filename="../plugin/gui/windows_panel.py" line="196"/>
        <source>Filter windows</source>
        <translation>Filtruj okna</translation>
    </message>
    <message>
        <location filename="../plugin/gui/windows_panel.py" line="197"/>
        <source>Shows the windows whose number, verdict, observer or reason matches.</source>
        <translation>Pokazuje okna, których numer, ocena, opinia obserwatora lub przyczyna pasuje do tekstu.</translation>
    </message>
    <message>
        <location filename="../plugin/gui/source_list.py" line="54"/>
        <source>all</source>
        <translation>wszystkie</translation>
    </message>
    <message>
        <location filename="../plugin/gui/windows_panel.py" line="200"/>
        <source>not judged</source>
        <translation>bez opinii</translation>
    </message>
    <message>
        <location filename="../plugin/gui/windows_panel.py" line="200"/>
        <source>changed</source>
        <translation>zmienione</translation>
    </message>
    <message>
        <location filename="../plugin/gui/windows_panel.py" line="205"/>
        <source>Windows without the observer&apos;s word.</source>
        <translation>Okna bez opinii obserwatora.</translation>
    </message>
    <message>
        <location filename="../plugin/gui/windows_panel.py" line="208"/>
        <source>Windows to be inspected again.</source>
        <translation>Okna do ponownej kontroli.</translation>
    </message>
    <message>
        <location filename="../plugin/gui/windows_panel.py" line="212"/>
        <source>Which windows are shown.</source>
        <translation>Które okna są pokazane.</translation>
    </message>
    <message>
        <location filename="../plugin/gui/windows_panel.py" line="214"/>
        <source>How many windows are shown.</source>
        <translation>Ile okien jest pokazanych.</translation>
    </message>
    <message>
        <location filename="../plugin/gui/windows_panel.py" line="233"/>
        <source>Zoom to window</source>
        <translation>Powiększ do okna</translation>
    </message>
    <message>
        <location filename="../plugin/gui/windows_panel.py" line="233"/>
        <source>Shows the window with one image pixel on 2 x 2 pixels of the screen.</source>
        <translation>Pokazuje okno tak, że piksel obrazu zajmuje 2 × 2 piksele ekranu.</translation>
    </message>
    <message>
        <location filename="../plugin/gui/windows_panel.py" line="233"/>
        <source>Inspect again</source>
        <translation>Skontroluj ponownie</translation>
    </message>
    <message>
        <location filename="../plugin/gui/windows_panel.py" line="233"/>
        <source>Measures the selected windows anew.</source>
        <translation>Mierzy zaznaczone okna od nowa.</translation>
    </message>
    <message>
        <location filename="../plugin/gui/windows_panel.py" line="233"/>
        <source>The loss of detail can be seen at 2x magnification.</source>
        <translation>Strata detali jest widoczna w powiększeniu 2×.</translation>
    </message>
    <message>
        <location filename="../plugin/gui/windows_panel.py" line="233"/>
        <source>The loss of detail can&apos;t be seen at 2x magnification.</source>
        <translation>Strata detali nie jest widoczna w powiększeniu 2×.</translation>
    </message>
    <message>
        <location filename="../plugin/gui/windows_panel.py" line="233"/>
        <source>Take judgement back</source>
        <translation>Wycofaj opinię</translation>
    </message>
    <message>
        <location filename="../plugin/gui/windows_panel.py" line="233"/>
        <source>The selected windows are not judged yet.</source>
        <translation>Zaznaczone okna pozostają bez opinii obserwatora.</translation>
    </message>
    <message>
        <location filename="../plugin/gui/windows_panel.py" line="233"/>
        <source>Remove</source>
        <translation>Usuń</translation>
    </message>
    <message>
        <location filename="../plugin/gui/windows_panel.py" line="233"/>
        <source>Removes the selected windows; undo brings them back.</source>
        <translation>Usuwa zaznaczone okna; cofnięcie je przywraca.</translation>
    </message>
    <message>
        <location filename="../plugin/gui/dock.py" line="132"/>
        <source>Draw</source>
        <translation>Rysuj</translation>
    </message>
    <message>
        <location filename="../plugin/gui/dock.py" line="132"/>
        <source>Click: a standard window, on the seam when one is near. Drag: a rectangle, with Shift a square.</source>
        <translation>Kliknięcie: okno standardowe, w pobliżu linii mozaikowania umieszczane na niej. Przeciągnięcie: prostokąt, z klawiszem Shift kwadrat.</translation>
    </message>
    <message>
        <location filename="../plugin/gui/dock.py" line="139"/>
        <source>Place</source>
        <translation>Rozmieść</translation>
    </message>
    <message>
        <location filename="../plugin/gui/dock.py" line="139"/>
        <source>Place windows along the seamlines</source>
        <translation>Rozmieść okna wzdłuż linii mozaikowania</translation>
    </message>
    <message>
        <location filename="../plugin/gui/dock.py" line="145"/>
        <source>Inspect</source>
        <translation>Skontroluj</translation>
    </message>
    <message>
        <location filename="../plugin/gui/dock.py" line="145"/>
        <source>Inspect all windows that are not inspected yet or have changed</source>
        <translation>Skontroluj wszystkie okna jeszcze nieskontrolowane lub zmienione</translation>
    </message>
    <message>
        <location filename="../plugin/gui/dock.py" line="151"/>
        <source>Again</source>
        <translation>Ponów</translation>
    </message>
    <message>
        <location filename="../plugin/gui/dock.py" line="151"/>
        <source>Inspect the selected windows again</source>
        <translation>Skontroluj ponownie zaznaczone okna</translation>
    </message>
    <message>
        <location filename="../plugin/gui/dock.py" line="157"/>
        <source>Stop</source>
        <translation>Zatrzymaj</translation>
    </message>
    <message>
        <location filename="../plugin/gui/dock.py" line="157"/>
        <source>Stop; what is done stays</source>
        <translation>Zatrzymaj; gotowe wyniki pozostają</translation>
    </message>
    <message>
        <location filename="../plugin/gui/dock.py" line="160"/>
        <source>Undo</source>
        <translation>Cofnij</translation>
    </message>
    <message>
        <location filename="../plugin/gui/dock.py" line="160"/>
        <source>Undo the last change of the windows (Ctrl+Z)</source>
        <translation>Cofnij ostatnią zmianę okien (Ctrl+Z)</translation>
    </message>
    <message>
        <location filename="../plugin/gui/dock.py" line="188"/>
        <source>Images</source>
        <translation>Obrazy</translation>
    </message>
    <message>
        <location filename="../plugin/gui/dock.py" line="269"/>
        <source>{done} of {asked} windows</source>
        <translation>Okna: {done} z {asked}</translation>
    </message>
    <message>
        <location filename="../plugin/gui/more_box.py" line="24"/>
        <source>More</source>
        <translation>Więcej</translation>
    </message>
    <message>
        <location filename="../plugin/gui/more_box.py" line="25"/>
        <source>Spacing of placed windows, wavelet, levels and the limit of a significant loss</source>
        <translation>Odstęp rozmieszczanych okien, falka, poziomy rozdzielczości i granica istotnej straty</translation>
    </message>
    <message>
        <location filename="../plugin/gui/more_box.py" line="27"/>
        <source>Metres along the seam from one placed window to the next</source>
        <translation>Odległość w metrach wzdłuż linii mozaikowania między kolejnymi rozmieszczanymi oknami</translation>
    </message>
    <message>
        <location filename="../plugin/gui/more_box.py" line="45"/>
        <source>A loss is significant when the mosaic keeps at most this share of the sources&apos; detail at level 1</source>
        <translation>Strata jest istotna, gdy ortofotomapa zachowuje na poziomie 1 najwyżej taką część detali ortoobrazów źródłowych</translation>
    </message>
    <message>
        <location filename="../plugin/gui/more_box.py" line="52"/>
        <source>S&amp;pacing</source>
        <translation>Odstę&amp;p okien</translation>
    </message>
    <message>
        <location filename="../plugin/gui/more_box.py" line="53"/>
        <source>Wa&amp;velet</source>
        <translation>&amp;Falka</translation>
    </message>
    <message>
        <location filename="../plugin/gui/more_box.py" line="54"/>
        <source>L&amp;evels</source>
        <translation>Po&amp;ziomy</translation>
    </message>
    <message>
        <location filename="../plugin/gui/more_box.py" line="55"/>
        <source>Significant up to &amp;ratio</source>
        <translation>Istotna strata &amp;do</translation>
    </message>
    <message>
        <location filename="../plugin/gui/windows_model.py" line="84"/>
        <source>Ratio at level {level}: {ratio}</source>
        <translation>Stosunek wariancji na poziomie {level}: {ratio}</translation>
    </message>
    <message>
        <location filename="../plugin/gui/windows_model.py" line="89"/>
        <source>ratio 1</source>
        <translation>stos. 1</translation>
    </message>
    <message>
        <location filename="../plugin/gui/windows_model.py" line="91"/>
        <source>id</source>
        <translation>nr</translation>
    </message>
    <message>
        <location filename="../plugin/gui/windows_model.py" line="92"/>
        <source>verdict</source>
        <translation>ocena</translation>
    </message>
    <message>
        <location filename="../plugin/gui/windows_model.py" line="93"/>
        <source>src.</source>
        <translation>źr.</translation>
    </message>
    <message>
        <location filename="../plugin/gui/windows_model.py" line="93"/>
        <source>sources</source>
        <translation>źródła</translation>
    </message>
    <message>
        <location filename="../plugin/gui/windows_model.py" line="94"/>
        <source>observer</source>
        <translation>obserwator</translation>
    </message>
    <message>
        <location filename="../plugin/gui/windows_model.py" line="95"/>
        <source>reason</source>
        <translation>przyczyna</translation>
    </message>
    <message>
        <location filename="../plugin/gui/windows_model.py" line="101"/>
        <source>Detail at level {level} in the mosaic as a multiple of the least sharp source&apos;s.</source>
        <translation>Stosunek wariancji detali na poziomie {level}: ortofotomapa względem najmniej ostrego ortoobrazu źródłowego.</translation>
    </message>
    <message>
        <location filename="../plugin/gui/windows_model.py" line="103"/>
        <source>Number of the window.</source>
        <translation>Numer okna.</translation>
    </message>
    <message>
        <location filename="../plugin/gui/windows_model.py" line="103"/>
        <source>What the ratio at level 1 says about the mosaic. Sorted by it, the worst comes first.</source>
        <translation>Co o ortofotomapie mówi stosunek wariancji na poziomie 1. Przy sortowaniu według oceny najgorsze okna są pierwsze.</translation>
    </message>
    <message>
        <location filename="../plugin/gui/windows_model.py" line="103"/>
        <source>How many sources the mosaic was compared with.</source>
        <translation>Z iloma ortoobrazami źródłowymi porównano ortofotomapę.</translation>
    </message>
    <message>
        <location filename="../plugin/gui/windows_model.py" line="103"/>
        <source>Whether the operator saw the loss of detail at 2x magnification.</source>
        <translation>Czy operator widział stratę detali w powiększeniu 2×.</translation>
    </message>
    <message>
        <location filename="../plugin/gui/windows_model.py" line="103"/>
        <source>Why the mosaic could not be compared with a source.</source>
        <translation>Dlaczego ortofotomapy nie udało się porównać z ortoobrazem źródłowym.</translation>
    </message>
    <message>
        <location filename="../plugin/gui/curves_panel.py" line="75"/>
        <source>Band whose curves are drawn; the verdict is that of luminance, or of the only band</source>
        <translation>Kanał, którego krzywe są rysowane; ocena dotyczy luminancji albo jedynego kanału</translation>
    </message>
    <message>
        <location filename="../plugin/gui/curves_panel.py" line="80"/>
        <source>log</source>
        <translation>log</translation>
    </message>
    <message>
        <location filename="../plugin/gui/curves_panel.py" line="81"/>
        <source>Logarithmic axis, which shows the fine levels; off: linear axis</source>
        <translation>Oś logarytmiczna, która uwidacznia najdokładniejsze poziomy; po wyłączeniu: oś liniowa</translation>
    </message>
    <message>
        <location filename="../plugin/gui/curves_panel.py" line="184"/>
        <source>The chart needs the Python package matplotlib: install python3-matplotlib with apt on Debian and Ubuntu, or run &apos;python -m pip install matplotlib&apos; in the OSGeo4W shell on Windows.</source>
        <translation>Wykres wymaga pakietu Pythona matplotlib: w systemach Debian i Ubuntu zainstaluj python3-matplotlib poleceniem apt, a w systemie Windows uruchom „python -m pip install matplotlib” w powłoce OSGeo4W.</translation>
    </message>
    <message>
        <location filename="../plugin/gui/source_list.py" line="54"/>
        <source>Check all rasters that overlap the mosaic</source>
        <translation>Zaznacz wszystkie rastry nachodzące na ortofotomapę</translation>
    </message>
    <message>
        <location filename="../plugin/gui/source_list.py" line="55"/>
        <source>Check no raster; missing ones are removed</source>
        <translation>Odznacz wszystkie rastry; brakujące zostaną usunięte</translation>
    </message>
    <message>
        <location filename="../plugin/gui/source_list.py" line="56"/>
        <source>The orthoimages that the mosaic was made from. Uncheck a missing one to remove it from the inputs.</source>
        <translation>Ortoobrazy, z których powstała ortofotomapa. Odznacz brakujący, aby usunąć go z danych wejściowych.</translation>
    </message>
    <message>
        <location filename="../plugin/gui/source_list.py" line="66"/>
        <source>&amp;Sources</source>
        <translation>Ź&amp;ródła</translation>
    </message>
    <message>
        <location filename="../plugin/gui/source_list.py" line="185"/>
        <source>Not in the project any more, or its file can&apos;t be opened: {name}</source>
        <translation>Nie ma go już w projekcie albo nie można otworzyć pliku: {name}</translation>
    </message>
    <message>
        <location filename="../plugin/gui/source_list.py" line="190"/>
        <source>does not overlap the mosaic: {path}</source>
        <translation>nie nachodzi na ortofotomapę: {path}</translation>
    </message>
    <message>
        <location filename="../plugin/gui/picture_view.py" line="102"/>
        <source>{name} (resampled)</source>
        <translation>{name} (przepróbkowany)</translation>
    </message>
    <message>
        <location filename="../plugin/gui/picture_view.py" line="280"/>
        <source>Drag to move, turn the wheel to zoom, hold Space to see the mosaic here.</source>
        <translation>Przeciągnij, aby przesunąć; obróć kółko, aby zmienić powiększenie; przytrzymaj spację, aby zobaczyć tu ortofotomapę.</translation>
    </message>
    <message>
        <location filename="../plugin/gui/window_tool.py" line="256"/>
        <source>no source covers it</source>
        <translation>bez pokrycia źródłami</translation>
    </message>
    <message>
        <location filename="../plugin/gui/window_tool.py" line="258"/>
        <source>{width:.1f} x {height:.1f} m, {columns} x {rows} px</source>
        <translation>{width:.1f} × {height:.1f} m, {columns} × {rows} px</translation>
    </message>
    <message>
        <location filename="../plugin/gui/session.py" line="190"/>
        <source>Place windows</source>
        <translation>Rozmieść okna</translation>
    </message>
    <message>
        <location filename="../plugin/gui/seam_finder.py" line="38"/>
        <source>Find seams</source>
        <translation>Znajdź linie mozaikowania</translation>
    </message>
    <message>
        <location filename="../plugin/gui/curves_export.py" line="36"/>
        <source>Save or copy what is shown: as a picture, or as a table of all values</source>
        <translation>Zapisz lub skopiuj to, co widać: jako obraz albo jako tabelę wszystkich wartości</translation>
    </message>
    <message>
        <location filename="../plugin/gui/curves_export.py" line="51"/>
        <source>The picture, for documents</source>
        <translation>Obraz do dokumentów</translation>
    </message>
    <message>
        <location filename="../plugin/gui/curves_export.py" line="52"/>
        <source>Save as SVG...</source>
        <translation>Zapisz jako SVG...</translation>
    </message>
    <message>
        <location filename="../plugin/gui/curves_export.py" line="52"/>
        <source>The picture, sharp at every size</source>
        <translation>Obraz ostry w każdej wielkości</translation>
    </message>
    <message>
        <location filename="../plugin/gui/curves_export.py" line="53"/>
        <source>Save as CSV...</source>
        <translation>Zapisz jako CSV...</translation>
    </message>
    <message>
        <location filename="../plugin/gui/curves_export.py" line="53"/>
        <source>All rasters and bands of the windows</source>
        <translation>Wszystkie rastry i kanały w oknach</translation>
    </message>
    <message>
        <location filename="../plugin/gui/curves_export.py" line="54"/>
        <source>Copy picture</source>
        <translation>Kopiuj obraz</translation>
    </message>
    <message>
        <location filename="../plugin/gui/curves_export.py" line="54"/>
        <source>To the clipboard</source>
        <translation>Do schowka</translation>
    </message>
    <message>
        <location filename="../plugin/gui/curves_export.py" line="55"/>
        <source>Copy values</source>
        <translation>Kopiuj wartości</translation>
    </message>
    <message>
        <location filename="../plugin/gui/curves_export.py" line="55"/>
        <source>To the clipboard, for a spreadsheet</source>
        <translation>Do schowka, do arkusza kalkulacyjnego</translation>
    </message>
    <message>
        <location filename="../plugin/gui/curves_export.py" line="65"/>
        <source>PNG picture</source>
        <translation>Obraz PNG</translation>
    </message>
    <message>
        <location filename="../plugin/gui/curves_export.py" line="69"/>
        <source>SVG picture</source>
        <translation>Obraz SVG</translation>
    </message>
    <message>
        <location filename="../plugin/gui/curves_export.py" line="73"/>
        <source>Table with commas</source>
        <translation>Tabela rozdzielana przecinkami</translation>
    </message>
    <message>
        <location filename="../plugin/gui/curves_export.py" line="98"/>
        <source>Save curves</source>
        <translation>Zapisz krzywe</translation>
    </message>
    <message>
        <location filename="../plugin/gui/curves_export.py" line="109"/>
        <source>The curves were not saved to {path}: {error}. Choose another folder.</source>
        <translation>Nie zapisano krzywych w {path}: {error}. Wybierz inny katalog.</translation>
    </message>
    <message>
        <location filename="../plugin/gui/curves_export.py" line="112"/>
        <source>The curves were saved to {path}.</source>
        <translation>Zapisano krzywe w {path}.</translation>
    </message>
    <message>
        <location filename="../plugin/gui/images_panel.py" line="55"/>
        <source>Screen pixels per image pixel</source>
        <translation>Liczba pikseli ekranu na piksel obrazu</translation>
    </message>
    <message>
        <location filename="../plugin/gui/images_panel.py" line="58"/>
        <source>Zoom all pictures out (wheel, -)</source>
        <translation>Pomniejsz wszystkie obrazy (kółko, -)</translation>
    </message>
    <message>
        <location filename="../plugin/gui/images_panel.py" line="59"/>
        <source>Zoom all pictures in (wheel, +)</source>
        <translation>Powiększ wszystkie obrazy (kółko, +)</translation>
    </message>
    <message>
        <location filename="../plugin/gui/images_panel.py" line="60"/>
        <source>Show all of the window</source>
        <translation>Pokaż całe okno</translation>
    </message>
    <message>
        <location filename="../plugin/gui/images_panel.py" line="61"/>
        <source>Back to 2x, at which loss of detail is best judged: each pixel is 2 x 2 on the screen</source>
        <translation>Powrót do 2×, przy którym najlepiej widać stratę detali: każdy piksel zajmuje na ekranie 2 × 2</translation>
    </message>
    <message>
        <location filename="../plugin/gui/images_panel.py" line="116"/>
        <source>Select a window, in the table or on the map, to see its pictures.</source>
        <translation>Zaznacz okno w tabeli lub na mapie, aby zobaczyć jego obrazy.</translation>
    </message>
    <message>
        <location filename="../plugin/gui/images_panel.py" line="120"/>
        <source>Choose the mosaic under Inputs to see the pictures of this window.</source>
        <translation>Wybierz ortofotomapę w danych wejściowych, aby zobaczyć obrazy tego okna.</translation>
    </message>
    <message>
        <location filename="../plugin/gui/images_panel.py" line="124"/>
        <source>No picture: neither the mosaic nor a source can be read in this window.</source>
        <translation>Brak obrazu: w tym oknie nie można odczytać ani ortofotomapy, ani ortoobrazu źródłowego.</translation>
    </message>
    <message>
        <location filename="../plugin/gui/images_panel.py" line="150"/>
        <source>Reading the pictures ...</source>
        <translation>Wczytywanie obrazów...</translation>
    </message>
    <message>
        <location filename="../plugin/gui/images_panel.py" line="189"/>
        <source>{window}: reading ...</source>
        <translation>{window}: wczytywanie...</translation>
    </message>
    <message>
        <location filename="../plugin/gui/images_panel.py" line="191"/>
        <source>{window}: no source covers it</source>
        <translation>{window}: bez pokrycia źródłami</translation>
    </message>
    <message>
        <location filename="../plugin/gui/images_panel.py" line="193"/>
        <source>{window} · Space: mosaic</source>
        <translation>{window} · spacja: ortofotomapa</translation>
    </message>
    <message>
        <location filename="../plugin/core/messages.py" line="158"/>
        <source>No window layer can be written to {folder}; save the project in a folder that you may write to.</source>
        <translation>Nie można zapisać warstwy okien w {folder}; zapisz projekt w katalogu, w którym masz prawo zapisu.</translation>
    </message>
    <message>
        <location filename="../plugin/core/messages.py" line="161"/>
        <source>The window layer {name} can&apos;t be edited; choose another one, or let a new one be made.</source>
        <translation>Warstwy okien {name} nie można edytować; wybierz inną albo pozwól utworzyć nową.</translation>
    </message>
    <message>
        <location filename="../plugin/core/messages.py" line="164"/>
        <source>The windows in {name} could not be saved with the project ({error}); they stay open for editing, so save that layer elsewhere.</source>
        <translation>Okien warstwy {name} nie udało się zapisać razem z projektem ({error}); warstwa pozostaje w trybie edycji, więc zapisz ją w innym miejscu.</translation>
    </message>
    <message>
        <location filename="../plugin/core/messages.py" line="168"/>
        <source>Windows placed along the seams: {count}. Inspect them when you are ready.</source>
        <translation>Liczba okien rozmieszczonych wzdłuż linii mozaikowania: {count}. Skontroluj je, gdy zechcesz.</translation>
    </message>
    <message>
        <location filename="../plugin/core/messages.py" line="169"/>
        <source>No mosaic is chosen; choose the mosaic in the inputs.</source>
        <translation>Nie wybrano ortofotomapy; wybierz ją w danych wejściowych.</translation>
    </message>
    <message>
        <location filename="../plugin/core/messages.py" line="170"/>
        <source>No seamlines are chosen; choose a layer of seamlines in the inputs.</source>
        <translation>Nie wybrano linii mozaikowania; wybierz ich warstwę w danych wejściowych.</translation>
    </message>
    <message>
        <location filename="../plugin/core/messages.py" line="171"/>
        <source>{task} failed ({error}); please report this.</source>
        <translation>Zadanie „{task}” nie powiodło się ({error}); zgłoś ten błąd.</translation>
    </message>
    <message>
        <location filename="../plugin/adapters/window_layer.py" line="117"/>
        <source>Add fields</source>
        <translation>Dodaj pola</translation>
    </message>
    <message>
        <location filename="../plugin/adapters/window_layer.py" line="154"/>
        <source>Add windows</source>
        <translation>Dodaj okna</translation>
    </message>
    <message>
        <location filename="../plugin/adapters/window_layer.py" line="166"/>
        <source>Number windows</source>
        <translation>Ponumeruj okna</translation>
    </message>
    <message>
        <location filename="../plugin/adapters/window_layer.py" line="184"/>
        <source>Judge windows</source>
        <translation>Wydaj opinię o oknach</translation>
    </message>
    <message>
        <location filename="../plugin/adapters/window_layer.py" line="191"/>
        <source>Remove windows</source>
        <translation>Usuń okna</translation>
    </message>
    <message>
        <location filename="../plugin/adapters/packages.py" line="23"/>
        <source>Seam Inspector needs the Python package(s) {packages}. On Debian and Ubuntu install {debian} with apt; on Windows run &apos;python -m pip install {packages}&apos; in the OSGeo4W shell. Then restart QGIS.</source>
        <translation>Wtyczka Seam Inspector wymaga pakietów Pythona: {packages}. W systemach Debian i Ubuntu zainstaluj {debian} poleceniem apt; w systemie Windows uruchom „python -m pip install {packages}” w powłoce OSGeo4W. Następnie uruchom QGIS ponownie.</translation>
    </message>
    <message>
        <location filename="../plugin/adapters/curves.py" line="54"/>
        <source>luminance</source>
        <translation>luminancja</translation>
    </message>
    <message>
        <location filename="../plugin/adapters/curves.py" line="55"/>
        <source>red</source>
        <translation>czerwony</translation>
    </message>
    <message>
        <location filename="../plugin/adapters/curves.py" line="56"/>
        <source>green</source>
        <translation>zielony</translation>
    </message>
    <message>
        <location filename="../plugin/adapters/curves.py" line="57"/>
        <source>blue</source>
        <translation>niebieski</translation>
    </message>
    <message>
        <location filename="../plugin/adapters/curves.py" line="58"/>
        <source>near infrared</source>
        <translation>bliska podczerwień</translation>
    </message>
    <message>
        <location filename="../plugin/adapters/curves.py" line="60"/>
        <source>band {number}</source>
        <translation>kanał {number}</translation>
    </message>
    <message>
        <location filename="../plugin/adapters/curves.py" line="92"/>
        <source>mosaic (mean)</source>
        <translation>ortofotomapa (średnia)</translation>
    </message>
    <message>
        <location filename="../plugin/adapters/curves.py" line="92"/>
        <source>sources (mean)</source>
        <translation>źródła (średnia)</translation>
    </message>
    <message>
        <location filename="../plugin/adapters/curves.py" line="122"/>
        <source>level {number}</source>
        <translation>poziom {number}</translation>
    </message>
    <message>
        <location filename="../plugin/adapters/curves.py" line="126"/>
        <source> (range {low} to {high})</source>
        <translation> (zakres od {low} do {high})</translation>
    </message>
    <message>
        <location filename="../plugin/adapters/curves.py" line="130"/>
        <source> ({percent:.0f} % of the lowest source)</source>
        <translation> ({percent:.0f}% najniższej wartości źródeł)</translation>
    </message>
    <message>
        <location filename="../plugin/adapters/curves.py" line="130"/>
        <source> ({percent:.0f} % of the least sharp source)</source>
        <translation> ({percent:.0f}% najmniej ostrego źródła)</translation>
    </message>
    <message>
        <location filename="../plugin/adapters/curves.py" line="135"/>
        <source> (mosaic: {percent:.0f} % of it)</source>
        <translation> (ortofotomapa: {percent:.0f}% tej wartości)</translation>
    </message>
    <message>
        <location filename="../plugin/gui/curves_export.py" line="51"/>
        <source>Save as PNG...</source>
        <translation>Zapisz jako PNG...</translation>
    </message>
</context>
</TS>
