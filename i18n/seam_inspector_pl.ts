<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1">
<context>
    <name>@default</name>
    <message>
        <location filename="../plugin/seams/algorithms/inspectwindows.py" line="38"/>
        <source>Inspect windows</source>
        <translation>Skontroluj okna</translation>
    </message>
    <message>
        <location filename="../plugin/noise/checknoise.py" line="64"/>
        <source>Windows</source>
        <translation>Okna</translation>
    </message>
    <message>
        <location filename="../plugin/seams/algorithms/inspectwindows.py" line="51"/>
        <source>Rectangles on the mosaic in any reference system, drawn or placed along the seamlines. The rectangle around each is measured, snapped to the mosaic&apos;s pixels.</source>
        <translation>Prostokąty na ortofotomapie, w dowolnym układzie współrzędnych, narysowane lub rozmieszczone wzdłuż linii mozaikowania. Pomiar obejmuje prostokąt opisany na każdym z nich, dociągnięty do siatki pikseli ortofotomapy.</translation>
    </message>
    <message>
        <location filename="../plugin/toolkit/algorithms/parameters.py" line="212"/>
        <source>Largest ratio of a significant loss</source>
        <translation>Największy stosunek wariancji przy istotnej stracie</translation>
    </message>
    <message>
        <location filename="../plugin/toolkit/algorithms/parameters.py" line="205"/>
        <source>Dask scheduler</source>
        <translation>Scheduler Dask</translation>
    </message>
    <message>
        <location filename="../plugin/seams/algorithms/inspectwindows.py" line="80"/>
        <source>Detail by direction</source>
        <translation>Detale według kierunków</translation>
    </message>
    <message>
        <location filename="../plugin/seams/algorithms/inspectwindows.py" line="81"/>
        <source>Adds to the curves of the mosaic and the sources the three directional components of each level: LH, in which horizontal lines show up, HL, vertical ones, and HH, diagonal ones. Their sum is the level&apos;s detail. Takes several times as long as the curves alone.</source>
        <translation>Dodaje do krzywych ortofotomapy i ortoobrazów źródłowych trzy komponenty kierunkowe każdego poziomu: LH, w którym ujawniają się linie poziome, HL – pionowe i HH – ukośne. Ich suma to detale tego poziomu. Trwa kilka razy dłużej niż same krzywe.</translation>
    </message>
    <message>
        <location filename="../plugin/toolkit/algorithms/parameters.py" line="206"/>
        <source>Address of a Dask scheduler (tcp://host:8786) whose workers see the rasters under the same paths. Empty: all cores of this machine.</source>
        <translation>Adres schedulera Dask (tcp://host:8786), którego procesy robocze widzą rastry pod tymi samymi ścieżkami. Puste pole: wszystkie rdzenie tego komputera.</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/acceptmosaic.py" line="70"/>
        <source>Inspected windows</source>
        <translation>Skontrolowane okna</translation>
    </message>
    <message>
        <location filename="../plugin/seams/algorithms/inspectwindows.py" line="90"/>
        <source>Curves</source>
        <translation>Krzywe</translation>
    </message>
    <message>
        <location filename="../plugin/seams/algorithms/inspectwindows.py" line="91"/>
        <source>Relative variance of every component, for each window, raster and band.</source>
        <translation>Wariancja względna każdego komponentu, dla każdego okna, rastra i kanału.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/algorithms/calibratethreshold.py" line="55"/>
        <source>Pairs</source>
        <translation>Pary</translation>
    </message>
    <message>
        <location filename="../plugin/seams/algorithms/inspectwindows.py" line="94"/>
        <source>The mosaic against each single source: ratios, similarity, sub-pixel offset.</source>
        <translation>Ortofotomapa względem każdego ortoobrazu źródłowego z osobna: stosunki wariancji, podobieństwo, przesunięcie podpikselowe.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/algorithms/inspectwindows.py" line="101"/>
        <source>Windows with a significant loss</source>
        <translation>Okna z istotną stratą</translation>
    </message>
    <message>
        <location filename="../plugin/seams/algorithms/inspectwindows.py" line="102"/>
        <source>Windows that can&apos;t be compared</source>
        <translation>Okna niedające się porównać</translation>
    </message>
    <message>
        <location filename="../plugin/seams/report/inspection_report.py" line="60"/>
        <source>Seam inspection</source>
        <translation>Kontrola linii mozaikowania</translation>
    </message>
    <message>
        <location filename="../plugin/toolkit/algorithms/feature_sinks.py" line="102"/>
        <source>A result can&apos;t be written; is the disk full?</source>
        <translation>Nie można zapisać wyniku; sprawdź, czy na dysku jest wolne miejsce.</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/paper/paper_head.py" line="52"/>
        <source>Mosaic</source>
        <translation>Ortofotomapa</translation>
    </message>
    <message>
        <location filename="../plugin/toolkit/algorithms/parameters.py" line="173"/>
        <source>The orthophoto mosaic under inspection: north-up, with a coordinate reference system.</source>
        <translation>Kontrolowana ortofotomapa: zorientowana na północ, z określonym układem współrzędnych.</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/paper/paper_head.py" line="55"/>
        <source>Sources</source>
        <translation>Ortoobrazy źródłowe</translation>
    </message>
    <message>
        <location filename="../plugin/toolkit/algorithms/parameters.py" line="179"/>
        <source>The orthoimages that the mosaic was made from. Each is clipped on its own pixel grid; one whose pixels differ in size by more than 1 %, or whose axes are not parallel, is resampled and marked so.</source>
        <translation>Ortoobrazy, z których powstała ortofotomapa. Każdy jest wycinany we własnej siatce pikseli; ortoobraz, którego piksel różni się wielkością o więcej niż 1 % lub którego osie nie są równoległe do osi ortofotomapy, jest przepróbkowywany i odpowiednio oznaczany.</translation>
    </message>
    <message>
        <location filename="../plugin/toolkit/algorithms/parameters.py" line="185"/>
        <source>Source index</source>
        <translation>Indeks ortoobrazów źródłowych</translation>
    </message>
    <message>
        <location filename="../plugin/toolkit/algorithms/parameters.py" line="186"/>
        <source>A tile index of orthoimages as gdaltindex writes it, with their paths in the field &apos;location&apos;; relative paths start at the index file&apos;s folder. For blocks with too many sources to load, alone or beside them.</source>
        <translation>Indeks kafli ortoobrazów w postaci zapisywanej przez gdaltindex, ze ścieżkami w polu „location”; ścieżki względne liczą się od katalogu pliku indeksu. Przydatny dla bloków, w których ortoobrazów jest zbyt wiele, aby je wczytać; można go podać zamiast nich albo razem z nimi.</translation>
    </message>
    <message>
        <location filename="../plugin/toolkit/algorithms/parameters.py" line="193"/>
        <source>Levels</source>
        <translation>Liczba poziomów rozdzielczości</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/inputs/inputs_panel.py" line="277"/>
        <source>Steps of the decomposition. Level 1 holds the finest detail, each further one detail twice as coarse.</source>
        <translation>Liczba kroków dekompozycji. Poziom 1 zawiera najdrobniejsze detale, każdy następny – detale dwukrotnie grubsze.</translation>
    </message>
    <message>
        <location filename="../plugin/toolkit/algorithms/parameters.py" line="199"/>
        <source>Wavelet</source>
        <translation>Falka</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/inputs/inputs_panel.py" line="275"/>
        <source>An orthogonal wavelet of PyWavelets; the Coiflet of order 3 is the one of Pyka&apos;s papers.</source>
        <translation>Falka ortogonalna z biblioteki PyWavelets; w pracach Pyki stosowany jest coiflet rzędu 3.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/algorithms/placewindows.py" line="27"/>
        <source>Place windows along seamlines</source>
        <translation>Rozmieść okna wzdłuż linii mozaikowania</translation>
    </message>
    <message>
        <location filename="../plugin/seams/algorithms/placewindows.py" line="29"/>
        <source>Places square windows of about 100 m along the seamlines of a mosaic, ready to be inspected. A window&apos;s side is the smallest power of two of pixels that spans the given length, and its edges are pixel edges of the mosaic. Windows that would stick out of the mosaic are moved along their seam; the log names those that had to be dropped.</source>
        <translation>Rozmieszcza wzdłuż linii mozaikowania ortofotomapy kwadratowe okna o boku około 100 m, gotowe do kontroli. Bok okna w pikselach jest najmniejszą potęgą liczby 2, która obejmuje zadaną długość, a krawędzie okna biegną po krawędziach pikseli ortofotomapy. Okna, które wystawałyby poza ortofotomapę, są przesuwane wzdłuż swojej linii mozaikowania; okna, które trzeba było pominąć, wymienia dziennik.</translation>
    </message>
    <message>
        <location filename="../plugin/radiometry/checkradiometry.py" line="81"/>
        <source>Seamlines</source>
        <translation>Linie mozaikowania</translation>
    </message>
    <message>
        <location filename="../plugin/seams/algorithms/placewindows.py" line="37"/>
        <source>Lines, or polygons that are each filled from one orthoimage: where two touch there is a seam. Fragments and pixel staircases are joined and straightened first.</source>
        <translation>Linie albo poligony, z których każdy jest wypełniony jednym ortoobrazem: linia mozaikowania biegnie tam, gdzie stykają się dwa poligony. Fragmenty linii są najpierw łączone, a przebiegi schodkowe (po krawędziach pikseli) prostowane.</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/planinspection.py" line="55"/>
        <source>Window side (metres)</source>
        <translation>Bok okna (metry)</translation>
    </message>
    <message>
        <location filename="../plugin/seams/algorithms/placewindows.py" line="44"/>
        <source>Spacing (metres)</source>
        <translation>Odstęp okien (metry)</translation>
    </message>
    <message>
        <location filename="../plugin/seams/algorithms/placewindows.py" line="45"/>
        <source>Distance between the centres of neighbouring windows, measured along the seam.</source>
        <translation>Odległość między środkami sąsiednich okien, mierzona wzdłuż linii mozaikowania.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/algorithms/placewindows.py" line="49"/>
        <source>The windows, with the number of their seam and their station along it in metres.</source>
        <translation>Okna z numerem linii mozaikowania i pikietażem wzdłuż niej w metrach.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/algorithms/placewindows.py" line="88"/>
        <source>{windows} windows placed along {seams} seams.</source>
        <translation>Rozmieszczono {windows} {windows:okno|okna|okien} wzdłuż {seams} {seams:linii|linii|linii} mozaikowania.</translation>
    </message>
    <message>
        <location filename="../plugin/imagery/messages.py" line="49"/>
        <source>The window side is {side} m; give a positive number of metres.</source>
        <translation>Bok okna wynosi {side} m; podaj dodatnią liczbę metrów.</translation>
    </message>
    <message>
        <location filename="../plugin/imagery/messages.py" line="71"/>
        <source>{levels} levels were asked for; give {least} to {most}.</source>
        <translation>Podano liczbę poziomów {levels}, a dekompozycja może ich mieć od {least} do {most}; podaj liczbę z tego zakresu.</translation>
    </message>
    <message>
        <location filename="../plugin/imagery/messages.py" line="76"/>
        <source>No two polygons of the seamline layer share a border; snap them to each other (gaps and overlaps up to half a pixel are bridged), or give the seams as lines.</source>
        <translation>Żadne dwa poligony warstwy linii mozaikowania nie mają wspólnej granicy; dociągnij je do siebie (szczeliny i nakładki do pół piksela są tolerowane) albo podaj linie mozaikowania jako linie.</translation>
    </message>
    <message>
        <location filename="../plugin/imagery/messages.py" line="79"/>
        <source>The lines of the seamline layer are shorter than a pixel of the mosaic; check the reference systems of both.</source>
        <translation>Linie w warstwie linii mozaikowania są krótsze niż piksel ortofotomapy; sprawdź układy współrzędnych warstwy i ortofotomapy.</translation>
    </message>
    <message>
        <location filename="../plugin/imagery/messages.py" line="81"/>
        <source>The seamline layer spans {width} x {height} px of the mosaic; check the reference systems of both.</source>
        <translation>Warstwa linii mozaikowania rozciąga się na {width} × {height} px ortofotomapy; sprawdź układy współrzędnych warstwy i ortofotomapy.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/measure/messages.py" line="28"/>
        <source>The spacing is {spacing} m; give a positive number of metres.</source>
        <translation>Odstęp okien wynosi {spacing} m; podaj dodatnią liczbę metrów.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/measure/messages.py" line="30"/>
        <source>A window of {side} m has {pixels} px a side on this mosaic and {levels} levels need at least {fewest} px; give a side of {metres} m or more.</source>
        <translation>Okno o boku {side} m ma na tej ortofotomapie bok {pixels} px, a {levels} {levels:poziom wymaga|poziomy wymagają|poziomów wymaga} co najmniej {fewest} px; podaj bok {metres} m lub większy.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/measure/messages.py" line="34"/>
        <source>The mosaic is {width:.1f} x {height:.1f} m, too small for a window of {side:.1f} m; give a shorter side.</source>
        <translation>Ortofotomapa ma {width:.1f} × {height:.1f} m i jest za mała na okno o boku {side:.1f} m; podaj krótszy bok.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/measure/messages.py" line="41"/>
        <source>Left out because they would share more than half of their pixels with another window of the same seam: {count}.</source>
        <translation>Okna pominięte, ponieważ miałyby ponad połowę pikseli wspólnych z innym oknem tej samej linii mozaikowania: {count}.</translation>
    </message>
    <message>
        <location filename="../plugin/imagery/messages.py" line="7"/>
        <source>{path} does not exist; check the path.</source>
        <translation>{path} nie istnieje; sprawdź ścieżkę.</translation>
    </message>
    <message>
        <location filename="../plugin/imagery/messages.py" line="10"/>
        <source>The pixels of {name} can&apos;t be read; the file may be truncated or damaged, so copy it again.</source>
        <translation>Nie można odczytać pikseli rastra {name}; plik może być niepełny lub uszkodzony, więc skopiuj go ponownie.</translation>
    </message>
    <message>
        <location filename="../plugin/imagery/messages.py" line="24"/>
        <source>{name} has no bands of its own; choose one of its subdatasets.</source>
        <translation>Raster {name} nie ma własnych kanałów; wybierz jeden z jego podzbiorów danych (subdatasets).</translation>
    </message>
    <message>
        <location filename="../plugin/imagery/messages.py" line="25"/>
        <source>{name} holds complex values; convert them to magnitudes first.</source>
        <translation>Raster {name} zawiera wartości zespolone; najpierw zamień je na moduły.</translation>
    </message>
    <message>
        <location filename="../plugin/imagery/messages.py" line="27"/>
        <source>{name} has no position on the map; georeference or orthorectify it first.</source>
        <translation>Raster {name} nie ma położenia na mapie; najpierw nadaj mu georeferencję lub wykonaj ortorektyfikację.</translation>
    </message>
    <message>
        <location filename="../plugin/imagery/messages.py" line="30"/>
        <source>{name} is rotated, mirrored or south-up; warp it to a north-up grid first.</source>
        <translation>Raster {name} jest obrócony, odbity lustrzanie lub zorientowany na południe; najpierw przepróbkuj go do siatki pikseli zorientowanej na północ.</translation>
    </message>
    <message>
        <location filename="../plugin/imagery/messages.py" line="63"/>
        <source>{name} does not cover the whole window.</source>
        <translation>Raster {name} nie pokrywa całego okna.</translation>
    </message>
    <message>
        <location filename="../plugin/imagery/messages.py" line="65"/>
        <source>{share:.2%} of the pixels of {name} are invalid in the window and {most:.1%} are allowed; choose another place.</source>
        <translation>Udział pikseli bez danych w oknie wynosi w rastrze {name} {share:.2%}, a dopuszczalne jest {most:.1%}; wybierz inne miejsce.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/measure/messages.py" line="16"/>
        <source>No sources are given; choose the orthoimages the mosaic was made from, or an index of them.</source>
        <translation>Nie podano ortoobrazów źródłowych; wybierz ortoobrazy, z których powstała ortofotomapa, albo warstwę ich indeksu.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/measure/messages.py" line="19"/>
        <source>{name} is the mosaic itself and is left out of the sources.</source>
        <translation>Raster {name} to sama ortofotomapa, więc nie zalicza się do ortoobrazów źródłowych.</translation>
    </message>
    <message>
        <location filename="../plugin/imagery/messages.py" line="40"/>
        <source>{name} is left out: {why}</source>
        <translation>Pominięto raster {name}: {why}</translation>
    </message>
    <message>
        <location filename="../plugin/seams/measure/messages.py" line="62"/>
        <source>No source covers the window; add the orthoimages that overlap it or choose another place.</source>
        <translation>Żaden ortoobraz źródłowy nie pokrywa okna; dodaj ortoobrazy z tego miejsca albo wybierz inne miejsce.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/measure/messages.py" line="63"/>
        <source>No source can be compared here: {why}</source>
        <translation>Żadnego ortoobrazu źródłowego nie można tu porównać: {why}</translation>
    </message>
    <message>
        <location filename="../plugin/seams/measure/messages.py" line="64"/>
        <source>The mosaic has no variance in the window; choose a place with content.</source>
        <translation>Ortofotomapa ma w oknie zerową wariancję; wybierz miejsce, gdzie jest treść.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/measure/messages.py" line="65"/>
        <source>{name} has no variance in the window; choose a place with content.</source>
        <translation>Raster {name} ma w oknie zerową wariancję; wybierz miejsce, gdzie jest treść.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/measure/messages.py" line="66"/>
        <source>No source has detail at level 1 in the window; choose a place with some.</source>
        <translation>Żaden ortoobraz źródłowy nie ma w oknie detali na poziomie 1; wybierz miejsce, gdzie są detale.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/measure/messages.py" line="67"/>
        <source>{name} has no {band} (its bands: {bands}); choose sources with the mosaic&apos;s bands.</source>
        <translation>Raster {name} nie ma kanału „{band}” (jego kanały: {bands}); wybierz ortoobrazy źródłowe o takich samych kanałach jak ortofotomapa.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/measure/messages.py" line="119"/>
        <source>The window could not be measured ({error}); please report this.</source>
        <translation>Nie udało się zmierzyć okna ({error}); zgłoś ten błąd.</translation>
    </message>
    <message>
        <location filename="../plugin/toolkit/messages.py" line="7"/>
        <source>{name} is not a raster layer; choose a raster.</source>
        <translation>{name} nie jest warstwą rastrową; wybierz raster.</translation>
    </message>
    <message>
        <location filename="../plugin/toolkit/messages.py" line="8"/>
        <source>{name} is not a file that GDAL reads but comes from a service; choose the raster file itself.</source>
        <translation>{name} nie jest plikiem odczytywanym przez GDAL, lecz pochodzi z usługi sieciowej; wybierz sam plik rastra.</translation>
    </message>
    <message>
        <location filename="../plugin/toolkit/messages.py" line="16"/>
        <source>The window has no outline; draw it again.</source>
        <translation>Okno nie ma obrysu; narysuj je od nowa.</translation>
    </message>
    <message>
        <location filename="../plugin/toolkit/messages.py" line="14"/>
        <source>The window layer is empty; draw windows or place them along the seamlines first.</source>
        <translation>Warstwa okien jest pusta; najpierw narysuj okna albo rozmieść je wzdłuż linii mozaikowania.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/measure/messages.py" line="18"/>
        <source>The index layer has no field &apos;{field}&apos;; make it with gdaltindex.</source>
        <translation>Warstwa indeksu nie ma pola „{field}”; utwórz ją poleceniem gdaltindex.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/charts/curves_painter.py" line="202"/>
        <source>background</source>
        <translation>tło</translation>
    </message>
    <message>
        <location filename="../plugin/noise/charts.py" line="178"/>
        <source>level</source>
        <translation>poziom rozdzielczości</translation>
    </message>
    <message>
        <location filename="../plugin/noise/charts.py" line="179"/>
        <source>relative variance</source>
        <translation>wariancja względna</translation>
    </message>
    <message>
        <location filename="../plugin/plugin.py" line="48"/>
        <source>Seam Inspector</source>
        <translation>Seam Inspector</translation>
    </message>
    <message>
        <location filename="../plugin/plugin.py" line="39"/>
        <source>Inspect how much detail a mosaic kept along its seams</source>
        <translation>Kontrola zachowania detali ortofotomapy wzdłuż linii mozaikowania</translation>
    </message>
    <message>
        <location filename="../plugin/resolution/desk/bar_dock.py" line="321"/>
        <source>Read pictures</source>
        <translation>Wczytaj obrazy</translation>
    </message>
    <message>
        <location filename="../plugin/seams/charts/curves_painter.py" line="330"/>
        <source>limit</source>
        <translation>granica</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/paper/inspection_record.py" line="91"/>
        <source>mosaic</source>
        <translation>ortofotomapa</translation>
    </message>
    <message>
        <location filename="../plugin/seams/words.py" line="36"/>
        <source>significant</source>
        <translation>istotna</translation>
    </message>
    <message>
        <location filename="../plugin/seams/words.py" line="37"/>
        <source>reduced</source>
        <translation>osłabione</translation>
    </message>
    <message>
        <location filename="../plugin/seams/words.py" line="38"/>
        <source>preserved</source>
        <translation>zachowane</translation>
    </message>
    <message>
        <location filename="../plugin/seams/words.py" line="40"/>
        <source>not comparable</source>
        <translation>nieporównywalne</translation>
    </message>
    <message>
        <location filename="../plugin/seams/words.py" line="42"/>
        <source>not inspected</source>
        <translation>bez kontroli</translation>
    </message>
    <message>
        <location filename="../plugin/seams/words.py" line="96"/>
        <source>visible</source>
        <translation>widoczna</translation>
    </message>
    <message>
        <location filename="../plugin/seams/words.py" line="96"/>
        <source>invisible</source>
        <translation>niewidoczna</translation>
    </message>
    <message>
        <location filename="../plugin/seams/words.py" line="42"/>
        <source>Not inspected yet.</source>
        <translation>Okno nie było jeszcze kontrolowane.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/words.py" line="40"/>
        <source>The mosaic could not be compared with a source here.</source>
        <translation>Ortofotomapy nie udało się tu porównać z żadnym ortoobrazem źródłowym.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/window_summary.py" line="137"/>
        <source>{finding} Changed since: inspect it again.</source>
        <translation>{finding} Od tego czasu nastąpiły zmiany: skontroluj okno ponownie.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/inputs/inputs_panel.py" line="147"/>
        <source>1 source</source>
        <translation>1 źródło</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/inputs/inputs_panel.py" line="147"/>
        <source>{count} sources</source>
        <translation>{count} {count:źródło|źródła|źródeł}</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/inputs/inputs_panel.py" line="151"/>
        <source>{count} missing</source>
        <translation>brakujące: {count}</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/inputs/inputs_panel.py" line="153"/>
        <source>source index</source>
        <translation>indeks źródeł</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/inputs/inputs_panel.py" line="155"/>
        <source>seamlines</source>
        <translation>linie mozaikowania</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/inputs/inputs_panel.py" line="182"/>
        <source>The smallest power of two of the mosaic&apos;s pixels that spans at least the given metres</source>
        <translation>Najmniejsza potęga liczby 2 pikseli ortofotomapy, która obejmuje co najmniej podaną liczbę metrów</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/inputs/inputs_panel.py" line="187"/>
        <source>too short</source>
        <translation>za krótki</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/inputs/inputs_panel.py" line="130"/>
        <source>choose the mosaic</source>
        <translation>wybierz ortofotomapę</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/inputs/inputs_panel.py" line="195"/>
        <source>The orthophoto mosaic under inspection: north-up, a file that GDAL reads</source>
        <translation>Kontrolowana ortofotomapa: zorientowana na północ, w pliku odczytywanym przez GDAL</translation>
    </message>
    <message>
        <location filename="../plugin/radiometry/report.py" line="89"/>
        <source>none</source>
        <translation>brak</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/inputs/inputs_panel.py" line="199"/>
        <source>A tile index of orthoimages as gdaltindex writes it, for blocks with too many sources to load: polygons with the field &apos;location&apos;</source>
        <translation>Indeks kafli ortoobrazów w postaci zapisywanej przez gdaltindex, dla bloków, w których ortoobrazów jest zbyt wiele, aby je wczytać: poligony z polem „location”</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/inputs/inputs_panel.py" line="204"/>
        <source>The mosaic&apos;s seams, or the polygons of its sources: windows are placed along them, and a click near one is moved onto it</source>
        <translation>Linie mozaikowania ortofotomapy albo poligony jej ortoobrazów źródłowych: wzdłuż nich rozmieszczane są okna, a kliknięcie w pobliżu linii jest na nią przesuwane</translation>
    </message>
    <message>
        <location filename="../plugin/resolution/desk/bar_dock.py" line="182"/>
        <source>new layer</source>
        <translation>nowa warstwa</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/inputs/inputs_panel.py" line="208"/>
        <source>The polygon layer that holds the windows; a new one is made with the first window</source>
        <translation>Warstwa poligonowa z oknami; nowa powstaje wraz z pierwszym oknem</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/inputs/inputs_panel.py" line="211"/>
        <source>Minimum side of a clicked or placed window, in metres</source>
        <translation>Najmniejsza długość boku klikniętego lub rozmieszczonego okna w metrach</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/inputs/inputs_panel.py" line="232"/>
        <source>&amp;Mosaic</source>
        <translation>&amp;Ortofotomapa</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/inputs/inputs_panel.py" line="234"/>
        <source>Source &amp;index</source>
        <translation>&amp;Indeks źródeł</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/inputs/inputs_panel.py" line="235"/>
        <source>Seam&amp;lines</source>
        <translation>&amp;Linie mozaikowania</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/inputs/inputs_panel.py" line="236"/>
        <source>&amp;Windows</source>
        <translation>O&amp;kna</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/inputs/inputs_panel.py" line="237"/>
        <source>Window si&amp;de</source>
        <translation>&amp;Bok okna</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/inputs/sources.py" line="350"/>
        <source>missing: {name}</source>
        <translation>brak: {name}</translation>
    </message>
    <message>
        <location filename="../plugin/toolkit/desk/widgets.py" line="334"/>
        <source>can&apos;t be used: {name}</source>
        <translation>nie można użyć: {name}</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/windows/window_columns.py" line="81"/>
        <source>{verdict}, changed</source>
        <translation>{verdict}, zmienione</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/charts/curves_tab.py" line="105"/>
        <source>Window {number}</source>
        <translation>Okno {number}</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/charts/curves_tab.py" line="131"/>
        <source>Select a window in the table or on the map, or draw one.</source>
        <translation>Zaznacz okno w tabeli lub na mapie albo je narysuj.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/charts/curves_tab.py" line="140"/>
        <source>This window can&apos;t be compared.</source>
        <translation>Tego okna nie można porównać.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/charts/curves_tab.py" line="136"/>
        <source>Measuring ...</source>
        <translation>Pomiar...</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/charts/curves_tab.py" line="141"/>
        <source>The curves are not saved with the project. Inspect again to see them.</source>
        <translation>Krzywe nie są zapisywane w projekcie. Aby je zobaczyć, skontroluj okno ponownie.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/charts/curves_tab.py" line="138"/>
        <source>Not inspected yet</source>
        <translation>Jeszcze nieskontrolowane</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/judge_bar.py" line="65"/>
        <source>Visible (V)</source>
        <translation>Widać (V)</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/judge_bar.py" line="69"/>
        <source>Invisible (I)</source>
        <translation>Nie widać (I)</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/judge_bar.py" line="76"/>
        <source>Next (N)</source>
        <translation>Dalej (N)</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/judge_bar.py" line="174"/>
        <source>Select a window to judge it.</source>
        <translation>Zaznacz okno, aby wydać opinię.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/windows/windows_panel.py" line="119"/>
        <source>Filter windows</source>
        <translation>Filtruj okna</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/paper/acceptance_report.py" line="246"/>
        <source>all</source>
        <translation>wszystkie</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/windows/windows_panel.py" line="65"/>
        <source>not judged</source>
        <translation>bez opinii</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/windows/windows_panel.py" line="67"/>
        <source>changed</source>
        <translation>zmienione</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/windows/windows_panel.py" line="65"/>
        <source>Windows that no observer has judged.</source>
        <translation>Okna bez opinii obserwatora.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/windows/windows_panel.py" line="67"/>
        <source>Windows to be inspected again.</source>
        <translation>Okna do ponownej kontroli.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/windows/windows_panel.py" line="59"/>
        <source>Which windows are shown.</source>
        <translation>Które okna są pokazane.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/judge_bar.py" line="66"/>
        <source>The loss of detail can be seen at 2x magnification.</source>
        <translation>Strata detali jest widoczna w powiększeniu 2×.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/judge_bar.py" line="70"/>
        <source>The loss of detail can&apos;t be seen at 2x magnification.</source>
        <translation>Strata detali nie jest widoczna w powiększeniu 2×.</translation>
    </message>
    <message>
        <location filename="../plugin/toolkit/desk/tool_dock.py" line="129"/>
        <source>Draw</source>
        <translation>Rysuj</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/dock.py" line="194"/>
        <source>Place</source>
        <translation>Rozmieść</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/dock.py" line="194"/>
        <source>Place windows along the seamlines</source>
        <translation>Rozmieść okna wzdłuż linii mozaikowania</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/dock.py" line="197"/>
        <source>Inspect</source>
        <translation>Skontroluj</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/dock.py" line="197"/>
        <source>Inspect all windows that are not inspected yet or have changed</source>
        <translation>Skontroluj wszystkie okna jeszcze nieskontrolowane lub zmienione</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/dock.py" line="215"/>
        <source>Again</source>
        <translation>Ponów</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/dock.py" line="215"/>
        <source>Inspect the selected windows again</source>
        <translation>Skontroluj ponownie zaznaczone okna</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/dock.py" line="218"/>
        <source>Stop</source>
        <translation>Zatrzymaj</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/dock.py" line="218"/>
        <source>Stop; what is done stays</source>
        <translation>Zatrzymaj; gotowe wyniki pozostają</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/desk_keys.py" line="73"/>
        <source>Undo</source>
        <translation>Cofnij</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/dock.py" line="247"/>
        <source>Images</source>
        <translation>Obrazy</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/dock.py" line="375"/>
        <source>{done} of {asked} windows</source>
        <translation>{done} z {asked} {asked:okna|okien|okien}</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/inputs/inputs_panel.py" line="256"/>
        <source>More</source>
        <translation>Więcej</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/inputs/inputs_panel.py" line="273"/>
        <source>Metres along the seam from one placed window to the next</source>
        <translation>Odległość w metrach wzdłuż linii mozaikowania między kolejnymi rozmieszczanymi oknami</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/inputs/inputs_panel.py" line="272"/>
        <source>S&amp;pacing</source>
        <translation>Odstę&amp;p okien</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/inputs/inputs_panel.py" line="274"/>
        <source>Wa&amp;velet</source>
        <translation>&amp;Falka</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/inputs/inputs_panel.py" line="276"/>
        <source>L&amp;evels</source>
        <translation>Po&amp;ziomy</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/windows/window_columns.py" line="120"/>
        <source>ratio 1</source>
        <translation>stos. 1</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/windows/window_columns.py" line="104"/>
        <source>id</source>
        <translation>nr</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/windows/window_columns.py" line="108"/>
        <source>verdict</source>
        <translation>ocena</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/windows/window_columns.py" line="136"/>
        <source>sources</source>
        <translation>ortoobrazów źródłowych</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/windows/window_columns.py" line="138"/>
        <source>observer</source>
        <translation>obserwator</translation>
    </message>
    <message>
        <location filename="../plugin/toolkit/layer_styles.py" line="37"/>
        <source>reason</source>
        <translation>powód</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/windows/window_columns.py" line="104"/>
        <source>Number of the window.</source>
        <translation>Numer okna.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/windows/window_columns.py" line="136"/>
        <source>How many sources the mosaic was compared with.</source>
        <translation>Z iloma ortoobrazami źródłowymi porównano ortofotomapę.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/windows/window_columns.py" line="139"/>
        <source>Whether the operator saw the loss of detail at 2x magnification.</source>
        <translation>Czy operator widział stratę detali w powiększeniu 2×.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/inputs/sources.py" line="267"/>
        <source>Untick all rasters and remove missing ones</source>
        <translation>Odznacz wszystkie rastry; brakujące zostaną usunięte</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/inputs/sources.py" line="280"/>
        <source>&amp;Sources</source>
        <translation>Ź&amp;ródła</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/inputs/sources.py" line="351"/>
        <source>Not in the project any more, or its file can&apos;t be opened: {name}</source>
        <translation>Nie ma go już w projekcie albo nie można otworzyć pliku: {name}</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/windows/new_windows.py" line="82"/>
        <source>Place windows</source>
        <translation>Rozmieść okna</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/map/under_mouse.py" line="59"/>
        <source>Find seams</source>
        <translation>Znajdź linie mozaikowania</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/charts/chart_widgets.py" line="171"/>
        <source>PNG picture</source>
        <translation>Obraz PNG</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/images/images_panel.py" line="147"/>
        <source>Select a window, in the table or on the map, to see its pictures.</source>
        <translation>Zaznacz okno w tabeli lub na mapie, aby zobaczyć jego obrazy.</translation>
    </message>
    <message>
        <location filename="../plugin/resolution/desk/bar_dock.py" line="320"/>
        <source>Reading the pictures ...</source>
        <translation>Wczytywanie obrazów...</translation>
    </message>
    <message>
        <location filename="../plugin/seams/measure/messages.py" line="56"/>
        <source>No window layer can be written to {folder}; save the project in a folder that you can write to.</source>
        <translation>Nie można zapisać warstwy okien w {folder}; zapisz projekt w katalogu, w którym masz prawo zapisu.</translation>
    </message>
    <message>
        <location filename="../plugin/toolkit/messages.py" line="10"/>
        <source>The window layer {name} can&apos;t be edited; choose another one, or let a new one be made.</source>
        <translation>Warstwy okien {name} nie można edytować; wybierz inną albo pozwól utworzyć nową.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/measure/messages.py" line="10"/>
        <source>No mosaic is chosen; choose the mosaic in the inputs.</source>
        <translation>Nie wybrano ortofotomapy; wybierz ją w danych wejściowych.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/measure/messages.py" line="26"/>
        <source>No seamlines are chosen; choose a layer of seamlines in the inputs.</source>
        <translation>Nie wybrano linii mozaikowania; wybierz ich warstwę w danych wejściowych.</translation>
    </message>
    <message>
        <location filename="../plugin/toolkit/messages.py" line="33"/>
        <source>{task} failed ({error}); please report this.</source>
        <translation>Zadanie „{task}” nie powiodło się ({error}); zgłoś ten błąd.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/windows/window_watch.py" line="131"/>
        <source>Number windows</source>
        <translation>Ponumeruj okna</translation>
    </message>
    <message>
        <location filename="../plugin/toolkit/translation.py" line="131"/>
        <source>luminance</source>
        <translation>luminancja</translation>
    </message>
    <message>
        <location filename="../plugin/toolkit/translation.py" line="132"/>
        <source>red</source>
        <translation>czerwony</translation>
    </message>
    <message>
        <location filename="../plugin/toolkit/translation.py" line="133"/>
        <source>green</source>
        <translation>zielony</translation>
    </message>
    <message>
        <location filename="../plugin/toolkit/translation.py" line="134"/>
        <source>blue</source>
        <translation>niebieski</translation>
    </message>
    <message>
        <location filename="../plugin/toolkit/translation.py" line="135"/>
        <source>near infrared</source>
        <translation>bliska podczerwień</translation>
    </message>
    <message>
        <location filename="../plugin/toolkit/translation.py" line="137"/>
        <source>band {number}</source>
        <translation>kanał {number}</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/charts/chart_widgets.py" line="70"/>
        <source>level {number}</source>
        <translation>poziom {number}</translation>
    </message>
    <message>
        <location filename="../plugin/plugin.py" line="40"/>
        <source>Bar groups</source>
        <translation>Grupy pasków</translation>
    </message>
    <message>
        <location filename="../plugin/plugin.py" line="41"/>
        <source>Draw lines across the groups of a bar target and watch their profiles</source>
        <translation>Rysuj linie w poprzek grup testu paskowego i oglądaj ich profile</translation>
    </message>
    <message>
        <location filename="../plugin/seams/charts/curves_painter.py" line="93"/>
        <source>composite</source>
        <translation>kompozycja</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/inputs/inputs_panel.py" line="146"/>
        <source>opening ...</source>
        <translation>otwieranie...</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/inputs/inputs_panel.py" line="146"/>
        <source>can&apos;t be used</source>
        <translation>nie można użyć</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/inputs/block_cache.py" line="104"/>
        <source>Open the mosaic</source>
        <translation>Otwórz ortofotomapę</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/inputs/inputs_panel.py" line="289"/>
        <source>Polygons that say in a field &apos;source&apos; which orthoimage the mosaic was cut from; without them that is found from the pixels</source>
        <translation>Poligony, które w polu „source” mówią, z którego ortoobrazu wycięto ortofotomapę; bez nich ustala się to z pikseli</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/inputs/inputs_panel.py" line="288"/>
        <source>Seam &amp;cells</source>
        <translation>&amp;Komórki ortofotomapy</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/windows/window_columns.py" line="132"/>
        <source>cause</source>
        <translation>przyczyna</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/windows/window_columns.py" line="133"/>
        <source>The step of production that explains what happened to the contrast.</source>
        <translation>Etap produkcji, który wyjaśnia, co się stało z kontrastem.</translation>
    </message>
    <message>
        <location filename="../plugin/photos/interiororientation.py" line="119"/>
        <source>HTML files (*.html)</source>
        <translation>Pliki HTML (*.html)</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/report_writer.py" line="48"/>
        <source>Save report</source>
        <translation>Zapisz raport</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/report_writer.py" line="48"/>
        <source>seam_inspection.html</source>
        <translation>kontrola_linii.html</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/report_writer.py" line="75"/>
        <source>Write the report</source>
        <translation>Zapisz raport z kontroli</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/report_writer.py" line="83"/>
        <source>Report of {count} windows: {link}.</source>
        <translation>Raport z {count} {count:okna|okien|okien}: {link}.</translation>
    </message>
    <message>
        <location filename="../plugin/resolution/desk/bar_dock.py" line="180"/>
        <source>no image</source>
        <translation>brak obrazu</translation>
    </message>
    <message>
        <location filename="../plugin/resolution/desk/bar_dock.py" line="67"/>
        <source> cm</source>
        <translation> cm</translation>
    </message>
    <message>
        <location filename="../plugin/resolution/desk/bar_dock.py" line="185"/>
        <source>along</source>
        <translation>wzdłuż</translation>
    </message>
    <message>
        <location filename="../plugin/resolution/desk/bar_dock.py" line="185"/>
        <source>across</source>
        <translation>w poprzek</translation>
    </message>
    <message>
        <location filename="../plugin/resolution/desk/bar_dock.py" line="178"/>
        <source>Draw a line across the bars of the group: drag, or click at both ends.</source>
        <translation>Narysuj linię w poprzek pasków grupy: przeciągnij albo kliknij na obu końcach.</translation>
    </message>
    <message>
        <location filename="../plugin/resolution/desk/bar_dock.py" line="289"/>
        <source>Measure a bar group</source>
        <translation>Zmierz grupę pasków</translation>
    </message>
    <message>
        <location filename="../plugin/resolution/desk/bar_dock.py" line="352"/>
        <source>Number of the group that is drawn next; it goes up by one with every line.</source>
        <translation>Numer grupy, która zostanie narysowana jako następna; rośnie o jeden z każdą linią.</translation>
    </message>
    <message>
        <location filename="../plugin/resolution/desk/bar_dock.py" line="71"/>
        <source>How many bars each group of the target has.</source>
        <translation>Ile pasków ma każda grupa testu.</translation>
    </message>
    <message>
        <location filename="../plugin/resolution/desk/bar_dock.py" line="72"/>
        <source>Number of the group whose distance is known. Higher numbers are finer.</source>
        <translation>Numer grupy o znanym wymiarze. Wyższe numery oznaczają drobniejsze grupy.</translation>
    </message>
    <message>
        <location filename="../plugin/resolution/desk/bar_dock.py" line="355"/>
        <source>Image</source>
        <translation>Obraz</translation>
    </message>
    <message>
        <location filename="../plugin/resolution/desk/bar_dock.py" line="356"/>
        <source>Lines</source>
        <translation>Linie</translation>
    </message>
    <message>
        <location filename="../plugin/resolution/desk/bar_dock.py" line="94"/>
        <source>Bars</source>
        <translation>Paski</translation>
    </message>
    <message>
        <location filename="../plugin/resolution/desk/bar_dock.py" line="95"/>
        <source>Reference</source>
        <translation>Odniesienie</translation>
    </message>
    <message>
        <location filename="../plugin/resolution/desk/bar_dock.py" line="358"/>
        <source>Group</source>
        <translation>Grupa</translation>
    </message>
    <message>
        <location filename="../plugin/resolution/charts.py" line="33"/>
        <source>resolved</source>
        <translation>rozróżniona</translation>
    </message>
    <message>
        <location filename="../plugin/resolution/charts.py" line="71"/>
        <source>along the line, px</source>
        <translation>wzdłuż linii, px</translation>
    </message>
    <message>
        <location filename="../plugin/resolution/simulatebayer.py" line="22"/>
        <source>Simulate a Bayer filter</source>
        <translation>Symuluj filtr Bayera</translation>
    </message>
    <message>
        <location filename="../plugin/toolkit/algorithms/base.py" line="36"/>
        <source>Ground resolution</source>
        <translation>Terenowa zdolność rozdzielcza</translation>
    </message>
    <message>
        <location filename="../plugin/resolution/simulatebayer.py" line="25"/>
        <source>Shows what a camera with a single chip would have seen of an image: each pixel records only the colour of its filter, and the other two are interpolated from the neighbours. Fine lines get wider and coloured (Walczykowski and others 2009, section 5). An image of one band is taken as a grey scene.</source>
        <translation>Pokazuje, co z danego obrazu zarejestrowałaby kamera z jedną matrycą: z każdego piksela zostaje tylko barwa jego filtra, a dwie pozostałe są interpolowane z sąsiednich pikseli. Cienkie linie stają się szersze i barwne (Walczykowski i in. 2009, rozdział 5). Obraz jednokanałowy jest traktowany jako scena w odcieniach szarości.</translation>
    </message>
    <message>
        <location filename="../plugin/resolution/simulatebayer.py" line="32"/>
        <source>A colour image, or one of a single band, north-up or without georeference.</source>
        <translation>Obraz barwny albo jednokanałowy, zorientowany na północ lub bez georeferencji.</translation>
    </message>
    <message>
        <location filename="../plugin/resolution/simulatebayer.py" line="34"/>
        <source>Pattern</source>
        <translation>Wzór filtra</translation>
    </message>
    <message>
        <location filename="../plugin/resolution/simulatebayer.py" line="35"/>
        <source>Colours of the filter over the first two pixels of the first row, then of the second.</source>
        <translation>Barwy filtra nad pierwszymi dwoma pikselami pierwszego wiersza, a potem drugiego.</translation>
    </message>
    <message>
        <location filename="../plugin/resolution/simulatebayer.py" line="37"/>
        <source>Interpolation</source>
        <translation>Interpolacja</translation>
    </message>
    <message>
        <location filename="../plugin/resolution/simulatebayer.py" line="42"/>
        <source>Seen by a single chip</source>
        <translation>Obraz z jednej matrycy</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/fitsensormodel.py" line="181"/>
        <source>Compare sensor models</source>
        <translation>Porównaj modele sensora</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/sensor_parameters.py" line="82"/>
        <source>Gives heights to points that have none.</source>
        <translation>Nadaje wysokości punktom, które ich nie mają.</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/sensor_parameters.py" line="81"/>
        <source>Heights of the points</source>
        <translation>Wysokości punktów</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/orthorectify.py" line="72"/>
        <source>Heights of the terrain model</source>
        <translation>Wysokości NMT</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/fitsensormodel.py" line="193"/>
        <source>Models</source>
        <translation>Modele</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/fitsensormodel.py" line="194"/>
        <source>One row per model: mean (root mean square) and largest errors in metres, the points used, or why not.</source>
        <translation>Jeden wiersz na model: błędy średnie (średniokwadratowe) i największe w metrach, użyte punkty albo przyczyna, dla której modelu nie użyto.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/algorithms/report.py" line="70"/>
        <source>Report</source>
        <translation>Raport</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/fitsensormodel.py" line="196"/>
        <source>The table with a chart and the recommendation.</source>
        <translation>Tabela z wykresem i zaleceniem.</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/fitsensormodel.py" line="198"/>
        <source>Recommended model</source>
        <translation>Zalecany model</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/fitsensormodel.py" line="199"/>
        <source>Recommendation with its reason</source>
        <translation>Zalecenie z uzasadnieniem</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/fitsensormodel.py" line="200"/>
        <source>Models judged</source>
        <translation>Ocenione modele</translation>
    </message>
    <message>
        <location filename="../plugin/seams/algorithms/predictloss.py" line="34"/>
        <source>Predict loss by feathering</source>
        <translation>Przewidź stratę wskutek wtapiania</translation>
    </message>
    <message>
        <location filename="../plugin/seams/algorithms/predictloss.py" line="36"/>
        <source>Predicts, before any mosaic is made, how much detail feathering would cost in each window. Where two images are blended half and half, the part of their detail that they do not share cancels: with rho the agreement of their detail coefficients, (1 + rho) / 2 of its variance is left. Images that lie 1 px apart can lose half of their finest detail this way. The smallest ratio over the pairs of sources says where feathering will hurt, so that the seam can go elsewhere, the images be registered better, or the feather made narrower.</source>
        <translation>Jeszcze przed wykonaniem ortofotomapy mówi, ile detali kosztowałoby wtapianie w każdym oknie. Gdzie dwa obrazy są mieszane pół na pół, znosi się ta część ich detali, która nie jest wspólna: przy zgodności rho ich współczynników detali zostaje (1 + rho) / 2 ich wariancji. Obrazy przesunięte względem siebie o 1 px mogą w ten sposób stracić połowę najdrobniejszych detali. Najmniejszy stosunek wariancji spośród par ortoobrazów źródłowych mówi, gdzie wtapianie zaszkodzi; można wtedy poprowadzić linię mozaikowania gdzie indziej, lepiej dopasować obrazy albo zwęzić pas wtapiania.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/algorithms/predictloss.py" line="45"/>
        <source>Rectangles where seams are to run, in any reference system. The rectangle around each is measured, snapped to the pixels of the finest source that covers it.</source>
        <translation>Prostokąty, przez które mają przebiegać linie mozaikowania, w dowolnym układzie współrzędnych. Pomiar obejmuje prostokąt opisany na każdym z nich, dociągnięty do siatki pikseli najdokładniejszego ortoobrazu źródłowego, który go pokrywa.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/algorithms/predictloss.py" line="52"/>
        <source>Width of the feather (metres)</source>
        <translation>Szerokość pasa wtapiania (metry)</translation>
    </message>
    <message>
        <location filename="../plugin/seams/algorithms/predictloss.py" line="57"/>
        <source>Ramp of the feather</source>
        <translation>Przebieg wag w pasie wtapiania</translation>
    </message>
    <message>
        <location filename="../plugin/seams/algorithms/predictloss.py" line="58"/>
        <source>How the weights of the two images change across the feather: in a straight line, as half a wave of the cosine, or as a mask smoothed by a Gaussian. The full width of the Gaussian is 4 sigma, from weights of 0.02 to 0.98.</source>
        <translation>Jak w poprzek pasa wtapiania zmieniają się wagi obu obrazów: liniowo, jak połowa fali cosinusa albo jak maska wygładzona filtrem Gaussa. Pełna szerokość przy filtrze Gaussa to 4 sigma, od wagi 0,02 do 0,98.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/algorithms/predictloss.py" line="67"/>
        <source>Predicted windows</source>
        <translation>Okna z prognozą</translation>
    </message>
    <message>
        <location filename="../plugin/seams/algorithms/predictloss.py" line="68"/>
        <source>The rectangles as measured, in the sources&apos; reference system, with the smallest ratio over the pairs.</source>
        <translation>Prostokąty w zmierzonych granicach, w układzie współrzędnych ortoobrazów źródłowych, z najmniejszym stosunkiem wariancji spośród par.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/algorithms/predictloss.py" line="70"/>
        <source>Source pairs</source>
        <translation>Pary ortoobrazów źródłowych</translation>
    </message>
    <message>
        <location filename="../plugin/seams/algorithms/predictloss.py" line="71"/>
        <source>Each pair of sources of a window: agreement of their detail, expected ratio, shift between them.</source>
        <translation>Każde dwa ortoobrazy źródłowe okna: zgodność ich detali, spodziewany stosunek wariancji, wzajemne przesunięcie.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/algorithms/report.py" line="32"/>
        <source>Report of an inspection</source>
        <translation>Raport z kontroli</translation>
    </message>
    <message>
        <location filename="../plugin/seams/algorithms/report.py" line="46"/>
        <source>The table of curves of the same windows; without it there are no relative variances and no charts.</source>
        <translation>Tabela krzywych tych samych okien; bez niej nie ma wariancji względnych ani wykresów.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/algorithms/report.py" line="55"/>
        <source>The inspected mosaic; with it the report shows the clips and an overview below the map sketch.</source>
        <translation>Skontrolowana ortofotomapa; z nią raport pokazuje wycinki i podgląd pod szkicem mapy.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/algorithms/report.py" line="58"/>
        <source>The orthoimages that the mosaic was made from; their clips stand beside its own.</source>
        <translation>Ortoobrazy, z których powstała ortofotomapa; ich wycinki stoją obok jej wycinków.</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/paper/paper_head.py" line="17"/>
        <source>Title</source>
        <translation>Tytuł</translation>
    </message>
    <message>
        <location filename="../plugin/seams/algorithms/report.py" line="61"/>
        <source>Heading of the page. Empty: the mosaics&apos; names.</source>
        <translation>Nagłówek strony. Puste pole: nazwy ortofotomap.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/algorithms/report.py" line="68"/>
        <source>The limit drawn in the charts: the one the windows were inspected with.</source>
        <translation>Granica rysowana na wykresach: ta, z którą skontrolowano okna.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/algorithms/report.py" line="70"/>
        <source>The page, one file.</source>
        <translation>Strona, jeden plik.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/algorithms/inspectwindows.py" line="58"/>
        <source>Verdict against</source>
        <translation>Ocena względem</translation>
    </message>
    <message>
        <location filename="../plugin/seams/algorithms/inspectwindows.py" line="63"/>
        <source>Seam cells</source>
        <translation>Komórki ortofotomapy</translation>
    </message>
    <message>
        <location filename="../plugin/seams/algorithms/inspectwindows.py" line="64"/>
        <source>Polygons that say in the field &apos;source&apos; which orthoimage each part of the mosaic was cut from. Where they are given they determine the composite; elsewhere it is found from the detail itself.</source>
        <translation>Poligony, które w polu „source” podają, z którego ortoobrazu źródłowego wycięto każdą część ortofotomapy. Gdzie są znane, decydują o kompozycji; w pozostałych miejscach jest ona ustalana na podstawie samych detali.</translation>
    </message>
    <message>
        <location filename="../plugin/resolution/measureresolution.py" line="49"/>
        <source>Measure ground resolved distance</source>
        <translation>Zmierz terenową zdolność rozdzielczą (GRD)</translation>
    </message>
    <message>
        <location filename="../plugin/resolution/measureresolution.py" line="61"/>
        <source>The image of the target, north-up. One without georeference is taken as QGIS shows it.</source>
        <translation>Obraz testu, zorientowany na północ. Obraz bez georeferencji jest brany tak, jak pokazuje go QGIS.</translation>
    </message>
    <message>
        <location filename="../plugin/resolution/measureresolution.py" line="63"/>
        <source>Lines across the bars</source>
        <translation>Linie w poprzek pasków</translation>
    </message>
    <message>
        <location filename="../plugin/resolution/measureresolution.py" line="70"/>
        <source>Width to average (pixels)</source>
        <translation>Szerokość uśredniania (piksele)</translation>
    </message>
    <message>
        <location filename="../plugin/resolution/measureresolution.py" line="73"/>
        <source>Band</source>
        <translation>Kanał</translation>
    </message>
    <message>
        <location filename="../plugin/resolution/measureresolution.py" line="73"/>
        <source>Number of the band to measure; 0 for every band.</source>
        <translation>Numer mierzonego kanału; 0 oznacza wszystkie kanały.</translation>
    </message>
    <message>
        <location filename="../plugin/resolution/measureresolution.py" line="74"/>
        <source>Bars in a group</source>
        <translation>Liczba pasków w grupie</translation>
    </message>
    <message>
        <location filename="../plugin/resolution/measureresolution.py" line="77"/>
        <source>Reference group</source>
        <translation>Grupa odniesienia</translation>
    </message>
    <message>
        <location filename="../plugin/resolution/measureresolution.py" line="82"/>
        <source>Distance of the reference group (cm)</source>
        <translation>GRD grupy odniesienia (cm)</translation>
    </message>
    <message>
        <location filename="../plugin/resolution/measureresolution.py" line="90"/>
        <source>Step from group to group</source>
        <translation>Krok między grupami</translation>
    </message>
    <message>
        <location filename="../plugin/resolution/measureresolution.py" line="91"/>
        <source>How many times as wide the next coarser group is; the sixth root of 2 on most targets.</source>
        <translation>Ile razy szersza jest następna, grubsza grupa; w większości testów pierwiastek szóstego stopnia z 2.</translation>
    </message>
    <message>
        <location filename="../plugin/resolution/measureresolution.py" line="93"/>
        <source>Criterion</source>
        <translation>Kryterium</translation>
    </message>
    <message>
        <location filename="../plugin/resolution/measureresolution.py" line="94"/>
        <source>Share of the full amplitude that the bars need for a group to be resolved.</source>
        <translation>Część pełnej amplitudy, którą zachowują paski rozróżnionej grupy.</translation>
    </message>
    <message>
        <location filename="../plugin/resolution/measureresolution.py" line="100"/>
        <source>Higher numbers are coarser</source>
        <translation>Wyższe numery oznaczają grubsze grupy</translation>
    </message>
    <message>
        <location filename="../plugin/resolution/measureresolution.py" line="101"/>
        <source>For targets numbered the other way.</source>
        <translation>Dla testów numerowanych odwrotnie.</translation>
    </message>
    <message>
        <location filename="../plugin/resolution/measureresolution.py" line="103"/>
        <source>Measured groups</source>
        <translation>Zmierzone grupy</translation>
    </message>
    <message>
        <location filename="../plugin/resolution/measureresolution.py" line="104"/>
        <source>The lines as they were measured, one row per band: bars, amplitudes, modulation, verdict, shift.</source>
        <translation>Linie w zmierzonym położeniu, jeden wiersz na kanał: paski, amplitudy, modulacja, ocena, przesunięcie.</translation>
    </message>
    <message>
        <location filename="../plugin/toolkit/algorithms/parameters.py" line="218"/>
        <source>Chart</source>
        <translation>Wykres</translation>
    </message>
    <message>
        <location filename="../plugin/resolution/measureresolution.py" line="106"/>
        <source>The profiles with their bars, threshold and verdict, group by group.</source>
        <translation>Profile z paskami, progiem i oceną, grupa po grupie.</translation>
    </message>
    <message>
        <location filename="../plugin/resolution/measureresolution.py" line="108"/>
        <source>A page with the distances, the target, the profiles and all measurements.</source>
        <translation>Strona z wartościami GRD, obrazem testu, profilami i wszystkimi pomiarami.</translation>
    </message>
    <message>
        <location filename="../plugin/resolution/measureresolution.py" line="29"/>
        <source>Distance along the flight (cm)</source>
        <translation>GRD wzdłuż kierunku lotu (cm)</translation>
    </message>
    <message>
        <location filename="../plugin/resolution/measureresolution.py" line="30"/>
        <source>Distance across the flight (cm)</source>
        <translation>GRD w poprzek kierunku lotu (cm)</translation>
    </message>
    <message>
        <location filename="../plugin/resolution/measureresolution.py" line="31"/>
        <source>Geometric mean of both distances (cm)</source>
        <translation>Średnia geometryczna obu wartości GRD (cm)</translation>
    </message>
    <message>
        <location filename="../plugin/noise/checknoise.py" line="37"/>
        <source>Check random noise</source>
        <translation>Sprawdź szum losowy</translation>
    </message>
    <message>
        <location filename="../plugin/toolkit/algorithms/base.py" line="35"/>
        <source>Image quality</source>
        <translation>Jakość obrazu</translation>
    </message>
    <message>
        <location filename="../plugin/noise/checknoise.py" line="52"/>
        <source>Rasters</source>
        <translation>Rastry</translation>
    </message>
    <message>
        <location filename="../plugin/noise/checknoise.py" line="53"/>
        <source>The images to be measured, 8 or 16 bit or float.</source>
        <translation>Mierzone obrazy, 8- lub 16-bitowe albo zmiennoprzecinkowe.</translation>
    </message>
    <message>
        <location filename="../plugin/noise/checknoise.py" line="55"/>
        <source>Second group</source>
        <translation>Druga grupa</translation>
    </message>
    <message>
        <location filename="../plugin/noise/checknoise.py" line="56"/>
        <source>Images of another camera, film or process, to be compared with the first. Pixel sizes may differ.</source>
        <translation>Obrazy z innej kamery, filmu lub procesu, do porównania z pierwszą grupą. Wielkości pikseli mogą się różnić.</translation>
    </message>
    <message>
        <location filename="../plugin/noise/checknoise.py" line="65"/>
        <source>Rectangles in any reference system; each is measured on all rasters under it. Without windows up to 25 of 1024 px are chosen on each raster, spread over its valid part, the least saturated first.</source>
        <translation>Prostokąty w dowolnym układzie współrzędnych; każdy jest mierzony na wszystkich rastrach, które obejmuje. Bez okien na każdym rastrze wybieranych jest do 25 okien o boku 1024 px, rozłożonych na części z danymi, najpierw najmniej przesycone.</translation>
    </message>
    <message>
        <location filename="../plugin/noise/checknoise.py" line="73"/>
        <source>Noise</source>
        <translation>Szum</translation>
    </message>
    <message>
        <location filename="../plugin/noise/checknoise.py" line="80"/>
        <source>The range of each group with its mean line, and the bands of one window. PNG, SVG or PDF.</source>
        <translation>Zakres każdej grupy z linią średniej oraz kanały jednego okna. PNG, SVG lub PDF.</translation>
    </message>
    <message>
        <location filename="../plugin/noise/checknoise.py" line="82"/>
        <source>All figures with the chart on one HTML page.</source>
        <translation>Wszystkie wartości z wykresem na jednej stronie HTML.</translation>
    </message>
    <message>
        <location filename="../plugin/noise/checknoise.py" line="26"/>
        <source>Windows with low noise</source>
        <translation>Okna z małym szumem</translation>
    </message>
    <message>
        <location filename="../plugin/noise/checknoise.py" line="28"/>
        <source>Windows with moderate noise</source>
        <translation>Okna z umiarkowanym szumem</translation>
    </message>
    <message>
        <location filename="../plugin/noise/checknoise.py" line="29"/>
        <source>Windows with strong noise</source>
        <translation>Okna z silnym szumem</translation>
    </message>
    <message>
        <location filename="../plugin/photos/enhancephoto.py" line="24"/>
        <source>Enhance photo</source>
        <translation>Popraw czytelność zdjęcia</translation>
    </message>
    <message>
        <location filename="../plugin/photos/enhancephoto.py" line="27"/>
        <source>Makes a photo easier to look at: its negative, 8 bit grey from colour or more bits, a mean or Gaussian against grain, Laplace or Sobel for edges. Photos of any size are processed in strips; georeference and invalid pixels are not changed. Marks are measured on the photo itself, not on this copy.</source>
        <translation>Ułatwia oglądanie zdjęcia: tworzy negatyw, 8-bitowy obraz szary z barwnego lub z większej liczby bitów, filtr uśredniający lub Gaussa przeciw ziarnu, Laplace’a lub Sobela dla krawędzi. Zdjęcia dowolnej wielkości są przetwarzane pasami; położenie na mapie i piksele bez danych są zachowane. Znaczki mierzy się na samym zdjęciu, a nie na tej kopii.</translation>
    </message>
    <message>
        <location filename="../plugin/photos/enhancephoto.py" line="33"/>
        <source>Photo</source>
        <translation>Zdjęcie</translation>
    </message>
    <message>
        <location filename="../plugin/photos/enhancephoto.py" line="33"/>
        <source>Any raster that GDAL reads.</source>
        <translation>Dowolny raster, który odczytuje GDAL.</translation>
    </message>
    <message>
        <location filename="../plugin/photos/enhancephoto.py" line="34"/>
        <source>Operation</source>
        <translation>Operacja</translation>
    </message>
    <message>
        <location filename="../plugin/photos/enhancephoto.py" line="35"/>
        <source>negative, mean and gaussian keep the data type; grey is 8 bit; laplace (second derivative) and sobel (length of the gradient) are floating point.</source>
        <translation>negative, mean i gaussian zachowują typ danych; grey jest 8-bitowy; laplace (druga pochodna) i sobel (długość gradientu) są zmiennoprzecinkowe.</translation>
    </message>
    <message>
        <location filename="../plugin/photos/enhancephoto.py" line="38"/>
        <source>Size (px)</source>
        <translation>Wielkość (px)</translation>
    </message>
    <message>
        <location filename="../plugin/photos/enhancephoto.py" line="39"/>
        <source>Side of the mean&apos;s square (odd), or standard deviation of the Gaussian; the others ignore it.</source>
        <translation>Bok kwadratu średniej (nieparzysty) albo odchylenie standardowe filtra Gaussa; bez znaczenia dla pozostałych.</translation>
    </message>
    <message>
        <location filename="../plugin/photos/enhancephoto.py" line="41"/>
        <source>Enhanced photo</source>
        <translation>Poprawione zdjęcie</translation>
    </message>
    <message>
        <location filename="../plugin/photos/enhancephoto.py" line="41"/>
        <source>A GeoTIFF.</source>
        <translation>Plik GeoTIFF.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/algorithms/calibratethreshold.py" line="38"/>
        <source>Calibrate the threshold</source>
        <translation>Kalibruj próg</translation>
    </message>
    <message>
        <location filename="../plugin/seams/algorithms/calibratethreshold.py" line="40"/>
        <source>Finds the limit of a significant loss that an observer&apos;s verdicts support. For every threshold it counts how many visible losses would be flagged and how many windows without one would be flagged by mistake: the ROC curve. The threshold to set is the one with the largest Youden index (sensitivity + specificity - 1) of the smoothed verdicts, with the 95 % interval of the true one; the area under the curve (AUC) says how well the measure tells both kinds apart, 0.5 being a guess, with its 95 % bootstrap interval. Windows that lie near each other are resampled together. With fewer than 5 visible or 5 invisible verdicts there is no number.</source>
        <translation>Znajduje granicę istotnej straty, którą potwierdzają opinie obserwatora. Dla każdego progu liczy, ile widocznych strat zostałoby oznaczonych i ile okien bez nich oznaczono by niepotrzebnie: krzywa ROC. Próg do ustawienia to ten z największym wskaźnikiem Youdena (czułość + swoistość - 1) opinii wygładzonych, z zakresem, w którym z ufnością 95 % leży próg prawdziwy; pole pod krzywą (AUC) mówi, jak dobrze miara rozdziela oba rodzaje, 0,5 to zgadywanie, z 95-procentowym przedziałem bootstrapowym. Okna leżące blisko siebie są losowane razem. Przy mniej niż 5 opiniach „widoczna” lub 5 „niewidoczna” nie ma liczby.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/algorithms/calibratethreshold.py" line="56"/>
        <source>The table of pairs of the same windows. With it the absolute contrast &apos;contrast_1&apos; is judged too: against the composite where there is one, else the largest over the sources.</source>
        <translation>Tabela par tych samych okien. Z nią oceniany jest też kontrast bezwzględny „contrast_1”: względem kompozycji, jeśli jest, w przeciwnym razie największy ze źródeł.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/algorithms/calibratethreshold.py" line="60"/>
        <source>The measure whose figures are given as outputs: the one the windows are judged by. Not set: &apos;kept_1&apos; where the judged windows have it, else &apos;ratio_1&apos;. The table and the chart hold all measures.</source>
        <translation>Miara, której dotyczą liczby: ta, według której okna są oceniane. Nieustawiona: „kept_1”, jeśli ocenione okna ją mają, w przeciwnym razie „ratio_1”. Tabela i wykres zawierają wszystkie.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/algorithms/calibratethreshold.py" line="59"/>
        <source>Measure</source>
        <translation>Miara</translation>
    </message>
    <message>
        <location filename="../plugin/photos/interiororientation.py" line="61"/>
        <source>Calibration</source>
        <translation>Kalibracja</translation>
    </message>
    <message>
        <location filename="../plugin/seams/algorithms/calibratethreshold.py" line="64"/>
        <source>For each measure a summary with the threshold to set, its range, the area and the verdicts wanted, what the standard limit does, and what every other threshold would do.</source>
        <translation>Dla każdej miary podsumowanie z progiem do ustawienia, jego zakresem, polem i liczbą potrzebnych opinii, działanie progu standardowego oraz każdego innego.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/algorithms/calibratethreshold.py" line="68"/>
        <source>ROC curves with their areas, and the judged windows of each measure.</source>
        <translation>Krzywe ROC z ich polami i ocenione okna każdej miary.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/algorithms/calibratethreshold.py" line="71"/>
        <source>Threshold of the measure</source>
        <translation>Próg miary</translation>
    </message>
    <message>
        <location filename="../plugin/seams/algorithms/calibratethreshold.py" line="72"/>
        <source>Area under the ROC curve</source>
        <translation>Pole pod krzywą ROC</translation>
    </message>
    <message>
        <location filename="../plugin/seams/algorithms/calibratethreshold.py" line="73"/>
        <source>Area, lower end of its interval</source>
        <translation>Pole, dolny koniec przedziału</translation>
    </message>
    <message>
        <location filename="../plugin/seams/algorithms/calibratethreshold.py" line="74"/>
        <source>Area, upper end of its interval</source>
        <translation>Pole, górny koniec przedziału</translation>
    </message>
    <message>
        <location filename="../plugin/seams/algorithms/calibratethreshold.py" line="75"/>
        <source>Visible verdicts</source>
        <translation>Opinie „widoczna”</translation>
    </message>
    <message>
        <location filename="../plugin/seams/algorithms/calibratethreshold.py" line="76"/>
        <source>Invisible verdicts</source>
        <translation>Opinie „niewidoczna”</translation>
    </message>
    <message>
        <location filename="../plugin/seams/algorithms/calibratethreshold.py" line="77"/>
        <source>Verdicts wanted</source>
        <translation>Potrzebne opinie</translation>
    </message>
    <message>
        <location filename="../plugin/resolution/minimumheight.py" line="92"/>
        <source>Minimum flying height</source>
        <translation>Minimalna wysokość lotu</translation>
    </message>
    <message>
        <location filename="../plugin/resolution/minimumheight.py" line="95"/>
        <source>Computes from passes over a bar target how low a sensor may fly without resolving more than agreed: for each pass its height times the required distance over the one that was read, then the mean of each group of passes, its spread, and how far it lies from a reference (Walczykowski and others 2009, equations 1 and 2).</source>
        <translation>Oblicza z przelotów nad testem paskowym, jak nisko może lecieć sensor, aby nie rozróżniał więcej, niż uzgodniono: dla każdego przelotu jego wysokość razy wymagana terenowa zdolność rozdzielcza przez odczytaną, a następnie średnią każdej grupy przelotów, jej rozrzut i odległość od wartości odniesienia (Walczykowski i in. 2009, wzory 1 i 2).</translation>
    </message>
    <message>
        <location filename="../plugin/resolution/minimumheight.py" line="101"/>
        <source>Observations</source>
        <translation>Obserwacje</translation>
    </message>
    <message>
        <location filename="../plugin/resolution/minimumheight.py" line="106"/>
        <source>Required distance (cm)</source>
        <translation>Wymagana GRD (cm)</translation>
    </message>
    <message>
        <location filename="../plugin/resolution/minimumheight.py" line="107"/>
        <source>The ground resolved distance that must not be undercut: 30 cm for optical cameras of Open Skies.</source>
        <translation>Terenowa zdolność rozdzielcza, poniżej której nie wolno zejść: 30 cm dla kamer optycznych w Open Skies.</translation>
    </message>
    <message>
        <location filename="../plugin/resolution/minimumheight.py" line="109"/>
        <source>Reference height (metres)</source>
        <translation>Wysokość odniesienia (metry)</translation>
    </message>
    <message>
        <location filename="../plugin/resolution/minimumheight.py" line="113"/>
        <source>Keep flying heights apart</source>
        <translation>Rozdziel wysokości lotu</translation>
    </message>
    <message>
        <location filename="../plugin/resolution/minimumheight.py" line="114"/>
        <source>Rows of different &apos;height&apos; make groups of their own, as in tables 4A and 4B of the paper.</source>
        <translation>Wiersze o różnym polu „height” tworzą osobne grupy, jak w tabelach 4A i 4B artykułu.</translation>
    </message>
    <message>
        <location filename="../plugin/resolution/minimumheight.py" line="116"/>
        <source>Minimum heights</source>
        <translation>Minimalne wysokości</translation>
    </message>
    <message>
        <location filename="../plugin/resolution/minimumheight.py" line="120"/>
        <source>Heights by pass</source>
        <translation>Wysokości z przelotów</translation>
    </message>
    <message>
        <location filename="../plugin/resolution/minimumheight.py" line="121"/>
        <source>The observations that were used, each with its minimum height &apos;h_min&apos;.</source>
        <translation>Użyte obserwacje, każda ze swoją minimalną wysokością „h_min”.</translation>
    </message>
    <message>
        <location filename="../plugin/resolution/minimumheight.py" line="123"/>
        <source>Groups</source>
        <translation>Grupy</translation>
    </message>
    <message>
        <location filename="../plugin/resolution/minimumheight.py" line="159"/>
        <source>all passes</source>
        <translation>wszystkie przeloty</translation>
    </message>
    <message>
        <location filename="../plugin/photos/interiororientation.py" line="46"/>
        <source>Interior orientation</source>
        <translation>Orientacja wewnętrzna</translation>
    </message>
    <message>
        <location filename="../plugin/toolkit/algorithms/base.py" line="37"/>
        <source>Interior orientation of photos</source>
        <translation>Orientacja wewnętrzna zdjęć</translation>
    </message>
    <message>
        <location filename="../plugin/photos/interiororientation.py" line="49"/>
        <source>Measures the fiducial marks of a scanned film photograph and fits the transformation from pixels to millimetres. A mark is found by normalised cross correlation and measured to a fraction of a pixel by the extremum of a second-degree surface (Mikrut and Chwastek 2007). A mark that can&apos;t be trusted fails with the reason; point at it on the map and give that point as its position, with the measurement off.</source>
        <translation>Mierzy znaczki tłowe skanowanego zdjęcia na filmie i wyznacza transformację z pikseli na milimetry. Znaczek jest wyszukiwany korelacją krzyżową i mierzony z podpikselową dokładnością jako ekstremum powierzchni drugiego stopnia (Mikrut i Chwastek 2007). Znaczek, któremu nie można ufać, jest odrzucany z podaniem przyczyny; wskaż go na mapie i podaj ten punkt jako jego położenie, z wyłączonym pomiarem.</translation>
    </message>
    <message>
        <location filename="../plugin/photos/interiororientation.py" line="121"/>
        <source>Marks measured or given</source>
        <translation>Znaczki zmierzone lub podane</translation>
    </message>
    <message>
        <location filename="../plugin/photos/interiororientation.py" line="122"/>
        <source>Marks that failed</source>
        <translation>Znaczki odrzucone</translation>
    </message>
    <message>
        <location filename="../plugin/photos/interiororientation.py" line="62"/>
        <source>The marks of the camera: a CSV with the columns mark, x_mm and y_mm, or MicMac&apos;s MeasuresCamera.xml. x to the right, y upwards. Rows named principal_point, focal_length (in x_mm) and data_strip (a place in it) are optional.</source>
        <translation>Znaczki kamery: plik CSV z kolumnami mark, x_mm i y_mm albo MeasuresCamera.xml z programu MicMac. Oś x w prawo, y w górę. Wiersze o nazwach principal_point, focal_length (w x_mm) i data_strip (miejsce w pasku danych) są opcjonalne.</translation>
    </message>
    <message>
        <location filename="../plugin/photos/interiororientation.py" line="66"/>
        <source>Template</source>
        <translation>Wzorzec</translation>
    </message>
    <message>
        <location filename="../plugin/photos/interiororientation.py" line="71"/>
        <source>Positions</source>
        <translation>Położenia</translation>
    </message>
    <message>
        <location filename="../plugin/photos/interiororientation.py" line="72"/>
        <source>Points with the field &apos;mark&apos;, digitised on the photo as QGIS shows it (without a world file x is the column and y the negative row). Without positions all of the photo is searched. A field &apos;measure&apos; with 0 says that a point is the mark itself.</source>
        <translation>Punkty z polem „mark”, zdigitalizowane na zdjęciu tak, jak pokazuje je QGIS (bez pliku world x to kolumna, a y to wiersz ze znakiem minus). Bez położeń przeszukiwane jest całe zdjęcie. Pole „measure” z wartością 0 oznacza, że punkt jest samym znaczkiem.</translation>
    </message>
    <message>
        <location filename="../plugin/photos/interiororientation.py" line="76"/>
        <source>Measure around the positions</source>
        <translation>Mierz wokół położeń</translation>
    </message>
    <message>
        <location filename="../plugin/photos/interiororientation.py" line="81"/>
        <source>Kind of mark</source>
        <translation>Rodzaj znaczka</translation>
    </message>
    <message>
        <location filename="../plugin/photos/interiororientation.py" line="82"/>
        <source>The shape to look for, in the size it has on the photo; automatic tries all.</source>
        <translation>Jaki wzorzec jest rysowany do wyszukiwania, w wielkości takiej jak na zdjęciu; automatic próbuje wszystkich.</translation>
    </message>
    <message>
        <location filename="../plugin/photos/interiororientation.py" line="83"/>
        <source>Direction of the arms</source>
        <translation>Kierunek ramion</translation>
    </message>
    <message>
        <location filename="../plugin/photos/interiororientation.py" line="84"/>
        <source>Whether the arms of a cross, or the wedges, stand upright or diagonally.</source>
        <translation>Czy ramiona krzyża lub kliny są ustawione prosto, czy ukośnie.</translation>
    </message>
    <message>
        <location filename="../plugin/photos/interiororientation.py" line="85"/>
        <source>Centre of the cross</source>
        <translation>Środek krzyża</translation>
    </message>
    <message>
        <location filename="../plugin/photos/interiororientation.py" line="85"/>
        <source>Whether a cross is open in the middle.</source>
        <translation>Czy krzyż jest otwarty w środku.</translation>
    </message>
    <message>
        <location filename="../plugin/photos/interiororientation.py" line="86"/>
        <source>Tone of the mark</source>
        <translation>Ton znaczka</translation>
    </message>
    <message>
        <location filename="../plugin/photos/interiororientation.py" line="87"/>
        <source>Whether the mark is lighter than its ground, as on most positives, or darker.</source>
        <translation>Czy znaczek jest jaśniejszy od tła, jak na większości pozytywów, czy ciemniejszy.</translation>
    </message>
    <message>
        <location filename="../plugin/photos/interiororientation.py" line="90"/>
        <source>Search (mm)</source>
        <translation>Zakres szukania (mm)</translation>
    </message>
    <message>
        <location filename="../plugin/photos/interiororientation.py" line="91"/>
        <source>How far around a position the mark is looked for.</source>
        <translation>Jak daleko wokół położenia szukany jest znaczek.</translation>
    </message>
    <message>
        <location filename="../plugin/photos/interiororientation.py" line="94"/>
        <source>Smallest correlation</source>
        <translation>Najmniejsza korelacja</translation>
    </message>
    <message>
        <location filename="../plugin/photos/interiororientation.py" line="95"/>
        <source>A mark whose best correlation is smaller fails.</source>
        <translation>Znaczek, którego największa korelacja jest mniejsza, jest odrzucany.</translation>
    </message>
    <message>
        <location filename="../plugin/photos/interiororientation.py" line="96"/>
        <source>Surface</source>
        <translation>Powierzchnia</translation>
    </message>
    <message>
        <location filename="../plugin/photos/interiororientation.py" line="97"/>
        <source>What the second-degree surface is laid through: the correlations around the best pixel, or the brightness of the photo as in the paper.</source>
        <translation>Przez co prowadzona jest powierzchnia drugiego stopnia: przez korelacje wokół najlepszego piksela albo przez jasność zdjęcia, jak w artykule.</translation>
    </message>
    <message>
        <location filename="../plugin/photos/interiororientation.py" line="100"/>
        <source>Transformation</source>
        <translation>Transformacja</translation>
    </message>
    <message>
        <location filename="../plugin/photos/interiororientation.py" line="101"/>
        <source>Needs at least 3 (affine), 2 (similarity) or 4 (projective) marks; with more there is a check.</source>
        <translation>Wymaga co najmniej 3 (affine), 2 (similarity) lub 4 (projective) znaczków; większa liczba daje kontrolę.</translation>
    </message>
    <message>
        <location filename="../plugin/photos/interiororientation.py" line="103"/>
        <source>Marks</source>
        <translation>Znaczki</translation>
    </message>
    <message>
        <location filename="../plugin/photos/interiororientation.py" line="108"/>
        <source>Parameters</source>
        <translation>Parametry</translation>
    </message>
    <message>
        <location filename="../plugin/photos/interiororientation.py" line="108"/>
        <source>JSON files (*.json)</source>
        <translation>Pliki JSON (*.json)</translation>
    </message>
    <message>
        <location filename="../plugin/photos/interiororientation.py" line="109"/>
        <source>Both directions of the transformation, pixel size, rotation, shear, principal point and accuracy.</source>
        <translation>Oba kierunki transformacji, wielkość piksela, obrót, nieortogonalność osi, punkt główny i dokładność.</translation>
    </message>
    <message>
        <location filename="../plugin/photos/interiororientation.py" line="110"/>
        <source>World file</source>
        <translation>Plik world</translation>
    </message>
    <message>
        <location filename="../plugin/photos/interiororientation.py" line="110"/>
        <source>World files (*.wld *.jgw *.tfw *.pgw *.bpw)</source>
        <translation>Pliki world (*.wld *.jgw *.tfw *.pgw *.bpw)</translation>
    </message>
    <message>
        <location filename="../plugin/photos/interiororientation.py" line="111"/>
        <source>Saved beside the photo under its name, it lets QGIS open the photo in millimetres.</source>
        <translation>Zapisany obok zdjęcia pod jego nazwą pozwala otworzyć zdjęcie w QGIS w milimetrach.</translation>
    </message>
    <message>
        <location filename="../plugin/photos/interiororientation.py" line="118"/>
        <source>A page with a picture of each mark and the place that was found.</source>
        <translation>Strona z obrazem każdego znaczka i znalezionym miejscem.</translation>
    </message>
    <message>
        <location filename="../plugin/toolkit/algorithms/base.py" line="38"/>
        <source>Satellite images</source>
        <translation>Obrazy satelitarne</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/point_tables.py" line="64"/>
        <source>the points</source>
        <translation>punkty</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/sensor_parameters.py" line="44"/>
        <source>Ground control points</source>
        <translation>Fotopunkty</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/sensor_parameters.py" line="90"/>
        <source>Reference system of a .points file</source>
        <translation>Układ współrzędnych pliku .points</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/sensor_parameters.py" line="92"/>
        <source>For files from before QGIS 3.26, which do not name the reference system of their map coordinates.</source>
        <translation>Dla plików sprzed QGIS 3.26, które nie podają układu swoich współrzędnych mapy.</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/sensor_parameters.py" line="53"/>
        <source>The satellite image as delivered, not georeferenced. Its size, satellite and RPC are taken from it.</source>
        <translation>Obraz satelitarny w postaci dostarczonej, bez georeferencji. Odczytywane są z niego wymiary, satelita i RPC.</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/fitsensormodel.py" line="267"/>
        <source>RPC of the image</source>
        <translation>RPC obrazu</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/sensor_parameters.py" line="79"/>
        <source>The vendor&apos;s RPC where GDAL does not find it beside the image: _RPC.TXT, .RPB, RPC_*.XML (DIMAP) or .geom.</source>
        <translation>RPC dostawcy, gdy GDAL nie znajduje go obok obrazu: _RPC.TXT, .RPB, RPC_*.XML (DIMAP) lub .geom.</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/sensor_parameters.py" line="58"/>
        <source>Terrain model</source>
        <translation>NMT</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/sensor_parameters.py" line="83"/>
        <source>Share of check points</source>
        <translation>Udział punktów kontrolnych</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/sensor_parameters.py" line="84"/>
        <source>Where no point has a role, this share of them, evenly spread, checks the fit and is not used in it. The same points give the same choice.</source>
        <translation>Gdy żaden punkt nie ma roli, taka ich część, równomiernie rozłożona, ocenia dopasowanie i nie bierze w nim udziału. Te same punkty dają ten sam wybór.</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/sensor_parameters.py" line="87"/>
        <source>Look for blunders</source>
        <translation>Szukaj błędów grubych</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/sensor_parameters.py" line="88"/>
        <source>Flags points that contradict the others and fits the model without them.</source>
        <translation>Oznacza punkty sprzeczne z innymi i dopasowuje model bez nich.</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/fitsensormodel.py" line="271"/>
        <source>Height of the orbit (km)</source>
        <translation>Wysokość orbity (km)</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/sensor_parameters.py" line="95"/>
        <source>Nominal, for the model pushbroom. Empty: by the satellite that the image&apos;s metadata name, else 694 km. IKONOS 681, QuickBird 450, EROS-A1 480, Pleiades 694, WorldView-3 617.</source>
        <translation>Nominalna, dla modelu pushbroom. Puste pole: według satelity podanego w metadanych obrazu, a w innym razie 694 km. IKONOS 681, QuickBird 450, EROS-A1 480, Pleiades 694, WorldView-3 617.</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/fitsensormodel.py" line="57"/>
        <source>Fit sensor model</source>
        <translation>Dopasuj model sensora</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/fitsensormodel.py" line="59"/>
        <source>Fits the geometry of a satellite image to ground control points and judges it on check points that the fit does not use (Kurczynski and Wolniewicz). The result is a model file and an RPC for orthorectification.</source>
        <translation>Dopasowuje geometrię obrazu satelitarnego do fotopunktów i ocenia ją na punktach kontrolnych, które nie brały udziału (Kurczyński i Wolniewicz). Wynikiem jest plik modelu i RPC do ortorektyfikacji.</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/fitsensormodel.py" line="66"/>
        <source>Model</source>
        <translation>Model</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/fitsensormodel.py" line="330"/>
        <source>{model}: {title}; needs at least {fewest} control points.</source>
        <translation>{model}: {title}; wymaga co najmniej {fewest} fotopunktów.</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/fitsensormodel.py" line="67"/>
        <source>Order</source>
        <translation>Stopień</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/fitsensormodel.py" line="68"/>
        <source>For polynomials and quotients. Higher orders need many points and oscillate between them.</source>
        <translation>Stopień modeli wielomianowych i ilorazowych. Wyższe stopnie wymagają wielu punktów i falują między nimi.</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/fitsensormodel.py" line="70"/>
        <source>Term a12 xy of the direct linear transformation</source>
        <translation>Wyraz a12 xy przekształcenia rzutowego (DLT)</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/fitsensormodel.py" line="71"/>
        <source>Adds one unknown to dlt, the product of column and row in the equation of the row (Fraser 2000).</source>
        <translation>Dodaje do dlt jedną niewiadomą: iloczyn kolumny i wiersza w równaniu wiersza (Fraser 2000).</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/fitsensormodel.py" line="73"/>
        <source>Correction of the RPC</source>
        <translation>Poprawka RPC</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/fitsensormodel.py" line="74"/>
        <source>For rpc_bias: a shift in the image, with a drift along the lines, or an affine change of the image.</source>
        <translation>Dla rpc_bias: przesunięcie na obrazie, z dryfem wzdłuż linii, albo afiniczna zmiana obrazu.</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/fitsensormodel.py" line="78"/>
        <source>Residuals</source>
        <translation>Odchyłki</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/fitsensormodel.py" line="79"/>
        <source>The points with residuals, model minus measured: in pixels, and in metres at the point&apos;s height.</source>
        <translation>Punkty z odchyłkami, model minus pomiar: w pikselach i w metrach na wysokości punktu.</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/fitsensormodel.py" line="82"/>
        <source>Model file</source>
        <translation>Plik modelu</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/fitsensormodel.py" line="82"/>
        <source>Model files (*.json)</source>
        <translation>Pliki modelu (*.json)</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/fitsensormodel.py" line="82"/>
        <source>The whole model, for orthorectification.</source>
        <translation>Cały model, do ortorektyfikacji.</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/fitsensormodel.py" line="83"/>
        <source>RPC</source>
        <translation>RPC</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/fitsensormodel.py" line="91"/>
        <source>Accuracy, warnings and a plot of the residuals.</source>
        <translation>Dokładność, ostrzeżenia i wykres odchyłek.</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/fitsensormodel.py" line="93"/>
        <source>check points</source>
        <translation>punkty kontrolne</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/fitsensormodel.py" line="93"/>
        <source>control points</source>
        <translation>fotopunkty</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/fitsensormodel.py" line="95"/>
        <source>Root mean square</source>
        <translation>Błąd średniokwadratowy</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/fitsensormodel.py" line="95"/>
        <source>Largest error</source>
        <translation>Największy błąd</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/fitsensormodel.py" line="96"/>
        <source>{kind} in {axis}, {group} (m)</source>
        <translation>{kind} na osi {axis}, {group} (m)</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/fitsensormodel.py" line="100"/>
        <source>Control points used</source>
        <translation>Użyte fotopunkty</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/fitsensormodel.py" line="100"/>
        <source>Check points used</source>
        <translation>Użyte punkty kontrolne</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/fitsensormodel.py" line="101"/>
        <source>Condition number</source>
        <translation>Wskaźnik uwarunkowania</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/fitsensormodel.py" line="152"/>
        <source>Check points</source>
        <translation>Punkty kontrolne</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/fitsensormodel.py" line="152"/>
        <source>Control points</source>
        <translation>Fotopunkty</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/fitsensormodel.py" line="159"/>
        <source>{name}: {count}, root mean square X {x:.3f} m, Y {y:.3f} m, largest X {max_x:.3f} m, Y {max_y:.3f} m</source>
        <translation>{name}: {count}, błąd średniokwadratowy X {x:.3f} m, Y {y:.3f} m, największy X {max_x:.3f} m, Y {max_y:.3f} m</translation>
    </message>
    <message>
        <location filename="../plugin/radiometry/checkradiometry.py" line="43"/>
        <source>Check radiometry</source>
        <translation>Sprawdź radiometrię</translation>
    </message>
    <message>
        <location filename="../plugin/radiometry/checkradiometry.py" line="54"/>
        <source>The images to be checked, each on its own.</source>
        <translation>Sprawdzane obrazy, każdy z osobna.</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/acceptmosaic.py" line="66"/>
        <source>Rules</source>
        <translation>Reguły</translation>
    </message>
    <message>
        <location filename="../plugin/radiometry/checkradiometry.py" line="82"/>
        <source>Lines, or polygons that are each filled from one orthoimage: the step of tone at the seams is measured on the rasters they cross, 2 to 10 px on either side.</source>
        <translation>Linie albo poligony, z których każdy jest wypełniony jednym ortoobrazem: skok tonalny na liniach mozaikowania jest mierzony na rastrach, które one przecinają, od 2 do 10 px po obu stronach.</translation>
    </message>
    <message>
        <location filename="../plugin/radiometry/checkradiometry.py" line="85"/>
        <source>Radiometry</source>
        <translation>Radiometria</translation>
    </message>
    <message>
        <location filename="../plugin/radiometry/checkradiometry.py" line="86"/>
        <source>One row per raster or window, check and band: value, limit, whether it passed, and the rule&apos;s source.</source>
        <translation>Jeden wiersz na raster lub okno, kontrolę i kanał: wartość, granica, czy jest spełniona oraz źródło reguły.</translation>
    </message>
    <message>
        <location filename="../plugin/radiometry/checkradiometry.py" line="99"/>
        <source>Figures that passed</source>
        <translation>Wartości spełniające reguły</translation>
    </message>
    <message>
        <location filename="../plugin/radiometry/checkradiometry.py" line="100"/>
        <source>Figures that failed</source>
        <translation>Wartości niespełniające reguł</translation>
    </message>
    <message>
        <location filename="../plugin/radiometry/checkradiometry.py" line="101"/>
        <source>Figures that can&apos;t be measured</source>
        <translation>Wartości, których nie można zmierzyć</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/orthorectify.py" line="123"/>
        <source>Orthorectify</source>
        <translation>Ortorektyfikuj</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/orthorectify.py" line="134"/>
        <source>As Fit sensor model writes it.</source>
        <translation>W postaci zapisanej przez algorytm „Dopasuj model sensora”.</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/orthorectify.py" line="135"/>
        <source>RPC file</source>
        <translation>Plik RPC</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/orthorectify.py" line="139"/>
        <source>Terrain heights under the whole image, in any reference system.</source>
        <translation>Wysokości terenu pod całym obrazem, w dowolnym układzie współrzędnych.</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/orthorectify.py" line="73"/>
        <source>Constant height (metres)</source>
        <translation>Stała wysokość (metry)</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/orthorectify.py" line="74"/>
        <source>Above the ellipsoid, instead of a terrain model: only where the terrain is flat.</source>
        <translation>Nad elipsoidą, zamiast NMT: tylko tam, gdzie teren jest płaski.</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/checkdelivery.py" line="57"/>
        <source>Reference system</source>
        <translation>Układ współrzędnych</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/orthorectify.py" line="141"/>
        <source>System of the orthoimage. Empty: that of the extent, or the UTM zone of the image&apos;s centre.</source>
        <translation>Układ ortoobrazu. Puste: układ zasięgu albo strefa UTM środka obrazu.</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/orthorectify.py" line="80"/>
        <source>Pixel size</source>
        <translation>Wielkość piksela</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/orthorectify.py" line="81"/>
        <source>In units of the reference system. Empty: that of the image on the ground.</source>
        <translation>W jednostkach układu współrzędnych. Puste pole: terenowy wymiar piksela obrazu.</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/orthorectify.py" line="142"/>
        <source>Extent</source>
        <translation>Zasięg</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/orthorectify.py" line="143"/>
        <source>Empty: the whole image. It is widened to whole pixels.</source>
        <translation>Puste pole: cały obraz. Zasięg jest poszerzany do całych pikseli.</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/orthorectify.py" line="83"/>
        <source>Resampling</source>
        <translation>Przepróbkowanie</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/orthorectify.py" line="84"/>
        <source>How pixels are interpolated.</source>
        <translation>Sposób interpolacji pikseli.</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/orthorectify.py" line="85"/>
        <source>Format</source>
        <translation>Format</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/orthorectify.py" line="86"/>
        <source>GeoTIFF, or cloud optimised GeoTIFF with overviews.</source>
        <translation>GeoTIFF albo GeoTIFF zoptymalizowany dla chmury (COG) z piramidami.</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/orthorectify.py" line="144"/>
        <source>Orthoimage</source>
        <translation>Ortoobraz</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/orthorectify.py" line="145"/>
        <source>A GeoTIFF; empty where the image or the terrain model ends.</source>
        <translation>Plik GeoTIFF; pusty tam, gdzie kończy się obraz lub NMT.</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/orthorectify.py" line="148"/>
        <source>Root mean square against the exact model (px)</source>
        <translation>Błąd średniokwadratowy względem modelu dokładnego (px)</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/orthorectify.py" line="149"/>
        <source>Largest error against the exact model (px)</source>
        <translation>Największy błąd względem modelu dokładnego (px)</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/orthorectify.py" line="150"/>
        <source>Share of the image without terrain heights</source>
        <translation>Część obrazu bez wysokości terenu</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/orthorectify.py" line="296"/>
        <source>{columns} x {rows} px of {size:g}; against the exact model {rms:.2g} px, at most {most:.2g} px.</source>
        <translation>{columns} × {rows} px o wielkości {size:g}; względem modelu dokładnego {rms:.2g} px, najwyżej {most:.2g} px.</translation>
    </message>
    <message>
        <location filename="../plugin/photos/comparemarks.py" line="43"/>
        <source>Compare marks</source>
        <translation>Porównaj znaczki</translation>
    </message>
    <message>
        <location filename="../plugin/photos/comparemarks.py" line="54"/>
        <source>Marks with the field &apos;mark&apos;, and &apos;photo&apos; (or &apos;layer&apos;, as merged layers have) where there are several photos. Places are the fields column and row, or the points themselves.</source>
        <translation>Znaczki z polem „mark” oraz „photo” (lub „layer”, jak w warstwach złączonych), gdy zdjęć jest kilka. Miejsca podają pola column i row albo same punkty.</translation>
    </message>
    <message>
        <location filename="../plugin/photos/comparemarks.py" line="62"/>
        <source>First measurement</source>
        <translation>Pierwszy pomiar</translation>
    </message>
    <message>
        <location filename="../plugin/photos/comparemarks.py" line="63"/>
        <source>Second measurement</source>
        <translation>Drugi pomiar</translation>
    </message>
    <message>
        <location filename="../plugin/photos/comparemarks.py" line="72"/>
        <source>Pixel size of the scan. Empty: taken from the fields x_mm and y_mm of the first layer that has them.</source>
        <translation>Piksel skanu. Puste pole: wielkość jest brana z pól x_mm i y_mm pierwszej warstwy, która je ma.</translation>
    </message>
    <message>
        <location filename="../plugin/photos/comparemarks.py" line="74"/>
        <source>Statistics</source>
        <translation>Statystyki</translation>
    </message>
    <message>
        <location filename="../plugin/photos/comparemarks.py" line="81"/>
        <source>Differences</source>
        <translation>Różnice</translation>
    </message>
    <message>
        <location filename="../plugin/photos/comparemarks.py" line="82"/>
        <source>The difference of each mark, the second measurement minus the first, in pixels.</source>
        <translation>Różnica dla każdego znaczka, drugi pomiar minus pierwszy, w pikselach.</translation>
    </message>
    <message>
        <location filename="../plugin/photos/comparemarks.py" line="137"/>
        <source>{count} marks: mean {mean:.3f}, maximum {maximum:.3f}, minimum {minimum:.3f} {unit}.</source>
        <translation>{count} {count:znaczek|znaczki|znaczków}: średnia {mean:.3f}, maksimum {maximum:.3f}, minimum {minimum:.3f} {unit}.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/measure/messages.py" line="21"/>
        <source>The layer of seam cells has no field &apos;source&apos;; add one with the file names of the orthoimages.</source>
        <translation>Warstwa komórek ortofotomapy nie ma pola „source”; dodaj je i wpisz nazwy plików ortoobrazów źródłowych.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/measure/messages.py" line="53"/>
        <source>No window could be placed along the seams; the log messages say why.</source>
        <translation>Wzdłuż linii mozaikowania nie udało się umieścić żadnego okna; przyczyny podaje dziennik komunikatów.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/measure/messages.py" line="11"/>
        <source>The mosaic is still being opened; try again in a moment.</source>
        <translation>Ortofotomapa jest jeszcze otwierana; spróbuj ponownie za chwilę.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/measure/messages.py" line="13"/>
        <source>The mosaic was not opened, as the task was cancelled; choose another mosaic in the inputs, then this one again.</source>
        <translation>Ortofotomapa nie została otwarta, ponieważ zadanie anulowano; wybierz w danych wejściowych inną ortofotomapę, a potem ponownie tę.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/measure/messages.py" line="121"/>
        <source>Only one source covers the window, so nothing will be feathered there.</source>
        <translation>Okno pokrywa tylko jeden ortoobraz źródłowy, więc nic nie będzie tam wtapiane.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/measure/messages.py" line="125"/>
        <source>Where no seamline divides a window in two, the seam is assumed to run through its middle.</source>
        <translation>Gdzie żadna linia mozaikowania nie dzieli okna na dwie części, zakłada się, że biegnie ona przez jego środek.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/measure/messages.py" line="122"/>
        <source>Only one source can be compared here: {why}</source>
        <translation>Tylko jeden ortoobraz źródłowy da się tu porównać: {why}</translation>
    </message>
    <message>
        <location filename="../plugin/imagery/messages.py" line="91"/>
        <source>{path} can&apos;t be written ({error}); choose another folder.</source>
        <translation>Nie można zapisać {path} ({error}); wybierz inny katalog.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/measure/messages.py" line="129"/>
        <source>The window layer has no field &apos;{field}&apos;; choose a layer of inspected windows, as &apos;Inspect windows&apos; leaves it.</source>
        <translation>Warstwa okien nie ma pola „{field}”; wybierz warstwę skontrolowanych okien, taką, jaką zostawia „Skontroluj okna”.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/measure/messages.py" line="150"/>
        <source>{measure}: {visible} visible and {invisible} invisible verdicts; a threshold needs at least {fewest} of either, so judge more windows.</source>
        <translation>{measure}: opinii „widoczna” jest {visible}, „niewidoczna” {invisible}; próg wymaga co najmniej {fewest} każdego rodzaju, oceń więc więcej okien.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/measure/messages.py" line="166"/>
        <source>Judged windows without an outline: {count}. Each counts as if no other lay near it, so the intervals may be too narrow; use the window layer itself.</source>
        <translation>Ocenione okna bez obrysu: {count}. Każde liczy się tak, jakby w pobliżu nie było innego, więc przedziały mogą być za wąskie; użyj samej warstwy okien.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/measure/messages.py" line="154"/>
        <source>{measure} does not reliably separate visible losses from others: the area under its curve lies between {low:.2f} and {high:.2f}, and 0.5 is a guess. Judge more windows before you rely on a threshold.</source>
        <translation>{measure} nie odróżnia na pewno strat widocznych od innych: pole pod krzywą leży między {low:.2f} a {high:.2f}, a 0,5 to zgadywanie. Oceń więcej okien, zanim zaufasz progowi.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/measure/messages.py" line="139"/>
        <source>Left out because the observer&apos;s word is neither &apos;visible&apos; nor &apos;invisible&apos;: {count} windows.</source>
        <translation>Pominięto {count} {count:okno|okna|okien}, bo opinia obserwatora to ani „visible”, ani „invisible”.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/measure/messages.py" line="147"/>
        <source>{measure}: left out because nothing was measured there: {count} judged windows.</source>
        <translation>{measure}: pominięto {count} {count:ocenione okno|ocenione okna|ocenionych okien}, bo nic tam nie zmierzono.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/measure/messages.py" line="178"/>
        <source>Window {window}: {why}</source>
        <translation>Okno {window}: {why}</translation>
    </message>
    <message>
        <location filename="../plugin/seams/measure/messages.py" line="177"/>
        <source>No file is given for the report; choose where it is to be written.</source>
        <translation>Nie podano pliku raportu; wybierz, gdzie ma być zapisany.</translation>
    </message>
    <message>
        <location filename="../plugin/imagery/messages.py" line="66"/>
        <source>No window could be measured: {why}</source>
        <translation>Nie udało się zmierzyć żadnego okna: {why}</translation>
    </message>
    <message>
        <location filename="../plugin/toolkit/messages.py" line="30"/>
        <source>No rasters are given; choose at least one.</source>
        <translation>Nie podano rastrów; wybierz co najmniej jeden.</translation>
    </message>
    <message>
        <location filename="../plugin/imagery/messages.py" line="92"/>
        <source>&apos;{output}&apos; would be written over {path}, which belongs to an input; choose another file.</source>
        <translation>„{output}” nadpisałby {path}, który należy do danych wejściowych; wybierz inny plik.</translation>
    </message>
    <message>
        <location filename="../plugin/imagery/messages.py" line="94"/>
        <source>&apos;{first}&apos; and &apos;{second}&apos; would be written to the same file, {path}; give each a file of its own.</source>
        <translation>„{first}” i „{second}” zostałyby zapisane do tego samego pliku, {path}; podaj dla każdego osobny plik.</translation>
    </message>
    <message>
        <location filename="../plugin/toolkit/messages.py" line="31"/>
        <source>None of the rasters can be used: {why}</source>
        <translation>Nie można użyć żadnego z rastrów: {why}</translation>
    </message>
    <message>
        <location filename="../plugin/noise/measure/messages.py" line="6"/>
        <source>{levels} levels asked for; the noise rule compares levels, so use at least {least}.</source>
        <translation>Podano liczbę poziomów {levels}; reguła szumu porównuje poziomy, więc użyj co najmniej {least}.</translation>
    </message>
    <message>
        <location filename="../plugin/noise/measure/messages.py" line="29"/>
        <source>{name} has no variance in {band} here; choose a place with content.</source>
        <translation>Raster {name} ma tu w kanale „{band}” zerową wariancję; wybierz miejsce, gdzie jest treść.</translation>
    </message>
    <message>
        <location filename="../plugin/noise/measure/messages.py" line="31"/>
        <source>The detail falls only after level 2, not from level 1 to 2: noise coarser than a pixel (grain, resampling, compression) or a texture of that size; look at the window.</source>
        <translation>Detale nie maleją z poziomu 1 na 2, lecz dalej: szum grubszy niż piksel (ziarno, przepróbkowanie, kompresja) albo tekstura tej wielkości; obejrzyj okno.</translation>
    </message>
    <message>
        <location filename="../plugin/imagery/messages.py" line="60"/>
        <source>Window {window} lies on none of the rasters; draw it on one of them.</source>
        <translation>Okno {window} nie leży na żadnym z rastrów; narysuj je na jednym z nich.</translation>
    </message>
    <message>
        <location filename="../plugin/imagery/messages.py" line="61"/>
        <source>Window {window} is left out on {name}: {why}</source>
        <translation>Okno {window} pominięto na rastrze {name}: {why}</translation>
    </message>
    <message>
        <location filename="../plugin/noise/measure/messages.py" line="13"/>
        <source>{name} has no valid part of {fewest} x {fewest} px; draw windows, or choose a larger raster.</source>
        <translation>Raster {name} nie ma części z danymi o wielkości {fewest} × {fewest} px; narysuj okna albo wybierz większy raster.</translation>
    </message>
    <message>
        <location filename="../plugin/noise/measure/messages.py" line="15"/>
        <source>{name} has no valid part of {wanted} x {wanted} px; its windows have {side} px.</source>
        <translation>Raster {name} nie ma części z danymi o wielkości {wanted} × {wanted} px; jego okna mają {side} px.</translation>
    </message>
    <message>
        <location filename="../plugin/noise/measure/messages.py" line="21"/>
        <source>The two groups show no common ground, so each raster has windows of its own and nothing is compared pairwise.</source>
        <translation>Obie grupy nie pokazują wspólnego terenu, więc każdy raster ma własne okna i nic nie jest porównywane parami.</translation>
    </message>
    <message>
        <location filename="../plugin/noise/measure/messages.py" line="25"/>
        <source>Pixel sizes differ ({first} and {second}), so a level does not mean the same size on the ground in both groups.</source>
        <translation>Wielkości pikseli różnią się ({first} i {second}), więc poziom nie oznacza w obu grupach tej samej wielkości w terenie.</translation>
    </message>
    <message>
        <location filename="../plugin/imagery/messages.py" line="104"/>
        <source>The rules in {name} can&apos;t be read ({error}); give a JSON file with rules.</source>
        <translation>Nie można odczytać reguł w pliku {name} ({error}); podaj plik JSON z regułami.</translation>
    </message>
    <message>
        <location filename="../plugin/imagery/messages.py" line="106"/>
        <source>{name} holds no rules; it has to be an object {{&quot;name&quot;: ..., &quot;rules&quot;: [...]}}.</source>
        <translation>Plik {name} nie zawiera reguł; musi być obiektem {{„name”: ..., „rules”: [...]}}.</translation>
    </message>
    <message>
        <location filename="../plugin/imagery/messages.py" line="108"/>
        <source>{place} in {name} has the unknown key &apos;{key}&apos;; known are {known}.</source>
        <translation>{place} w pliku {name}: nieznany klucz „{key}”; znane są {known}.</translation>
    </message>
    <message>
        <location filename="../plugin/imagery/messages.py" line="111"/>
        <source>{place} in {name}: &apos;least&apos; is larger than &apos;most&apos;.</source>
        <translation>{place} w pliku {name}: „least” jest większe niż „most”.</translation>
    </message>
    <message>
        <location filename="../plugin/radiometry/measure/messages.py" line="8"/>
        <source>{place} in {name}: &apos;values&apos; belongs to clipped_low and clipped_high only.</source>
        <translation>{place} w pliku {name}: „values” stosuje się tylko do clipped_low i clipped_high.</translation>
    </message>
    <message>
        <location filename="../plugin/imagery/messages.py" line="114"/>
        <source>{place} in {name} has no &apos;source&apos;; say in words where the limit comes from.</source>
        <translation>{place} w pliku {name}: brak „source”; podaj słownie, skąd pochodzi granica.</translation>
    </message>
    <message>
        <location filename="../plugin/imagery/messages.py" line="115"/>
        <source>Rule {number}</source>
        <translation>Reguła {number}</translation>
    </message>
    <message>
        <location filename="../plugin/imagery/messages.py" line="116"/>
        <source>The object</source>
        <translation>Obiekt</translation>
    </message>
    <message>
        <location filename="../plugin/radiometry/measure/messages.py" line="17"/>
        <source>not measurable: {why}</source>
        <translation>niemierzalne: {why}</translation>
    </message>
    <message>
        <location filename="../plugin/radiometry/measure/messages.py" line="18"/>
        <source>{count} pixels are valid and at least {least} are needed; choose a larger part.</source>
        <translation>liczba pikseli z danymi wynosi {count}, a potrzeba co najmniej {least}; wybierz większą część.</translation>
    </message>
    <message>
        <location filename="../plugin/radiometry/measure/messages.py" line="30"/>
        <source>fewer than {least} uniform mid-tone areas of {side} x {side} px were found; draw windows on such areas.</source>
        <translation>znaleziono mniej niż {least} jednorodnych obszarów {side} × {side} px o średnich tonach; narysuj okna na takich obszarach.</translation>
    </message>
    <message>
        <location filename="../plugin/radiometry/measure/messages.py" line="33"/>
        <source>the uniform areas do not vary at all; a photograph would, so check how the image was made.</source>
        <translation>obszary jednorodne wcale się nie zmieniają; na zdjęciu tak nie bywa, więc sprawdź, jak powstał obraz.</translation>
    </message>
    <message>
        <location filename="../plugin/radiometry/measure/messages.py" line="44"/>
        <source>it has no red, green and blue.</source>
        <translation>brak kanałów czerwonego, zielonego i niebieskiego.</translation>
    </message>
    <message>
        <location filename="../plugin/radiometry/measure/messages.py" line="47"/>
        <source>no seam runs across valid pixels of it for {pixels} px or more.</source>
        <translation>żadna linia mozaikowania nie biegnie przez piksele z danymi na długości {pixels} px lub większej.</translation>
    </message>
    <message>
        <location filename="../plugin/radiometry/measure/messages.py" line="48"/>
        <source>The rules set no limit; give one in the rules file.</source>
        <translation>Reguły nie określają żadnej granicy; podaj ją w pliku reguł.</translation>
    </message>
    <message>
        <location filename="../plugin/imagery/messages.py" line="26"/>
        <source>{name} has no band {band} to measure; give 1 to {count}, or 0 for every band.</source>
        <translation>Raster {name} nie ma kanału {band}; podaj numer od 1 do {count} albo 0 dla wszystkich kanałów.</translation>
    </message>
    <message>
        <location filename="../plugin/resolution/measure/messages.py" line="11"/>
        <source>The layer has no field &apos;{field}&apos;; add it and fill it in.</source>
        <translation>Warstwa nie ma pola „{field}”; dodaj je i wypełnij.</translation>
    </message>
    <message>
        <location filename="../plugin/resolution/measure/messages.py" line="8"/>
        <source>The layer has no lines; draw one across the bars of each group.</source>
        <translation>Warstwa nie ma linii; narysuj po jednej w poprzek pasków każdej grupy.</translation>
    </message>
    <message>
        <location filename="../plugin/resolution/measure/messages.py" line="14"/>
        <source>The line leaves {name}; draw it on the image, across the bars of the group.</source>
        <translation>Linia wychodzi poza raster {name}; narysuj ją na obrazie, w poprzek pasków grupy.</translation>
    </message>
    <message>
        <location filename="../plugin/resolution/measure/messages.py" line="15"/>
        <source>The line crosses pixels of {name} without data; draw it where the image is.</source>
        <translation>Linia przecina piksele rastra {name} bez danych; narysuj ją tam, gdzie jest obraz.</translation>
    </message>
    <message>
        <location filename="../plugin/resolution/measure/messages.py" line="17"/>
        <source>The line is {length:.1f} px long, and {bars} bars with their gaps need {least} px at least; draw it from the ground on one side of the bars to that on the other.</source>
        <translation>Linia ma długość {length:.1f} px, a {bars} {bars:pasek|paski|pasków} z przerwami {bars:wymaga|wymagają|wymaga} co najmniej {least} px; narysuj ją od tła po jednej stronie pasków do tła po drugiej.</translation>
    </message>
    <message>
        <location filename="../plugin/resolution/measure/messages.py" line="20"/>
        <source>The line is {length:.0f} px long and {most} px are the most; draw it across the bars of one group only.</source>
        <translation>Linia ma długość {length:.0f} px, a największa dopuszczalna to {most} px; narysuj ją w poprzek pasków tylko jednej grupy.</translation>
    </message>
    <message>
        <location filename="../plugin/resolution/measure/messages.py" line="21"/>
        <source>The line has no whole number in its field &apos;group&apos;; fill in the group&apos;s number.</source>
        <translation>Linia nie ma liczby całkowitej w polu „group”; wpisz numer grupy.</translation>
    </message>
    <message>
        <location filename="../plugin/resolution/measure/messages.py" line="22"/>
        <source>The line&apos;s direction is &apos;{direction}&apos;; fill in &apos;along&apos; or &apos;across&apos;.</source>
        <translation>Kierunek linii to „{direction}”; wpisz „along” lub „across”.</translation>
    </message>
    <message>
        <location filename="../plugin/resolution/measure/messages.py" line="26"/>
        <source>Group {group} {direction} is drawn twice; the first line counts, so delete this one or correct its number.</source>
        <translation>Grupę {group} (kierunek „{direction}”) narysowano dwa razy; liczy się pierwsza linia, więc usuń tę albo popraw jej numer.</translation>
    </message>
    <message>
        <location filename="../plugin/resolution/measure/messages.py" line="29"/>
        <source>No bars stand out on the line; draw it across the bars of one group.</source>
        <translation>Na linii nie widać pasków; narysuj ją w poprzek pasków jednej grupy.</translation>
    </message>
    <message>
        <location filename="../plugin/resolution/measure/messages.py" line="30"/>
        <source>The bars can&apos;t be told apart: {found} of {bars} stand out.</source>
        <translation>Pasków nie można rozróżnić: widać {found} z {bars}.</translation>
    </message>
    <message>
        <location filename="../plugin/resolution/measure/messages.py" line="31"/>
        <source>{found} bars stand out and a group has {bars}; draw the line across one group only.</source>
        <translation>Widać {found} {found:pasek|paski|pasków}, a grupa ma ich {bars}; narysuj linię w poprzek tylko jednej grupy.</translation>
    </message>
    <message>
        <location filename="../plugin/resolution/measure/messages.py" line="32"/>
        <source>The amplitude is {share:.0%} of the full one and the criterion is {criterion:.0%}.</source>
        <translation>Amplituda wynosi {share:.0%} pełnej, a kryterium {criterion:.0%}.</translation>
    </message>
    <message>
        <location filename="../plugin/resolution/measure/messages.py" line="34"/>
        <source>The amplitude of {amplitude:.1f} DN does not exceed three times the noise of {noise:.1f} DN.</source>
        <translation>Amplituda {amplitude:.1f} DN nie przekracza trzykrotności szumu {noise:.1f} DN.</translation>
    </message>
    <message>
        <location filename="../plugin/resolution/measure/messages.py" line="36"/>
        <source>A bar and a gap cover {cycle:.2f} px, fewer than two: what is seen there is aliasing and is not counted.</source>
        <translation>Pasek i przerwa zajmują {cycle:.2f} px, mniej niż dwa: to, co tam widać, to aliasing i nie jest liczone.</translation>
    </message>
    <message>
        <location filename="../plugin/resolution/measure/messages.py" line="39"/>
        <source>The bars seem {spacing:.1f} px apart, which can&apos;t be told from aliasing in an image without scale; draw lines across coarser groups too.</source>
        <translation>Odstęp pasków wynosi pozornie {spacing:.1f} px, czego w obrazie bez skali nie można odróżnić od aliasingu; narysuj linie także w poprzek grubszych grup.</translation>
    </message>
    <message>
        <location filename="../plugin/resolution/measure/messages.py" line="42"/>
        <source>The bars seem {spacing:.1f} px apart, but those of the group are {cycle:.1f} px: what is seen is aliasing or another group, and is not counted.</source>
        <translation>Odstęp pasków wynosi pozornie {spacing:.1f} px, a w tej grupie powinien wynosić {cycle:.1f} px: to, co widać, to aliasing albo inna grupa i nie jest liczone.</translation>
    </message>
    <message>
        <location filename="../plugin/resolution/measure/messages.py" line="44"/>
        <source>A coarser group, {group}, is not resolved, so this one is aliasing and is not counted.</source>
        <translation>Grubsza grupa {group} nie jest rozróżniona, więc ta to aliasing i nie jest liczona.</translation>
    </message>
    <message>
        <location filename="../plugin/resolution/measure/messages.py" line="46"/>
        <source>The bars are saturated at {value:g} DN, so the full amplitude is larger than measured; use an image with a shorter exposure.</source>
        <translation>Paski są przesycone przy {value:g} DN, więc pełna amplituda jest większa niż zmierzona; użyj obrazu o krótszej ekspozycji.</translation>
    </message>
    <message>
        <location filename="../plugin/resolution/measure/messages.py" line="50"/>
        <source>The bars are {ratio:.2f} times as far apart as their group numbers and the pixel size say; the measured bars are used, so check the reference group, its distance and the raster&apos;s pixel size.</source>
        <translation>Odstęp pasków jest {ratio:.2f} razy taki, jak wynika z numerów grup i wielkości piksela; przyjęto odstęp zmierzony, więc sprawdź grupę odniesienia, jej GRD i wielkość piksela rastra.</translation>
    </message>
    <message>
        <location filename="../plugin/resolution/measure/messages.py" line="53"/>
        <source>The bars get wider where the group numbers say that they get finer; set REVERSED for this target, or clear it.</source>
        <translation>Paski są coraz szersze tam, gdzie według numerów grup powinny być drobniejsze; włącz REVERSED dla tego testu albo wyłącz.</translation>
    </message>
    <message>
        <location filename="../plugin/resolution/measure/messages.py" line="56"/>
        <source>No group {direction} the flight is resolved in {band}, so there is no ground resolved distance.</source>
        <translation>W kanale {band} żadna grupa w kierunku „{direction}” względem lotu nie jest rozróżniona, więc nie ma terenowej zdolności rozdzielczej.</translation>
    </message>
    <message>
        <location filename="../plugin/resolution/measure/messages.py" line="88"/>
        <source>{count} passes over the target; the Open Skies treaty asks for {least} at least.</source>
        <translation>Liczba przelotów nad testem: {count}; traktat o otwartych przestworzach (Open Skies) wymaga co najmniej {least}.</translation>
    </message>
    <message>
        <location filename="../plugin/resolution/measure/messages.py" line="76"/>
        <source>No row has a height and a distance to compute with; fill in &apos;height&apos; and &apos;grd&apos;.</source>
        <translation>Żaden wiersz nie ma wysokości i GRD do obliczeń; wypełnij „height” i „grd”.</translation>
    </message>
    <message>
        <location filename="../plugin/resolution/measure/messages.py" line="77"/>
        <source>Row {row} is left out: {why}</source>
        <translation>Wiersz {row} pominięto: {why}</translation>
    </message>
    <message>
        <location filename="../plugin/resolution/measure/messages.py" line="78"/>
        <source>&apos;height&apos; or &apos;grd&apos; holds no number; fill in both.</source>
        <translation>„height” lub „grd” nie zawiera liczby; wypełnij oba pola.</translation>
    </message>
    <message>
        <location filename="../plugin/resolution/measure/messages.py" line="96"/>
        <source>{name} has {count} bands and no red, green and blue; choose a colour image, or one of a single band.</source>
        <translation>Raster {name} ma {count} {count:kanał|kanały|kanałów}, ale nie ma kanałów czerwonego, zielonego i niebieskiego; wybierz obraz barwny albo jednokanałowy.</translation>
    </message>
    <message>
        <location filename="../plugin/resolution/measure/messages.py" line="10"/>
        <source>No layer of bar groups can be written to {folder}; save the project in a folder that you can write to.</source>
        <translation>Nie można zapisać warstwy grup pasków w {folder}; zapisz projekt w katalogu, w którym masz prawo zapisu.</translation>
    </message>
    <message>
        <location filename="../plugin/resolution/measure/messages.py" line="7"/>
        <source>No image of a bar target is chosen; choose one above, then draw a line across its bars.</source>
        <translation>Nie wybrano obrazu testu paskowego; wybierz go powyżej, a potem narysuj linię w poprzek pasków.</translation>
    </message>
    <message>
        <location filename="../plugin/photos/measure/messages.py" line="46"/>
        <source>The template is {width} x {height} px and a side needs at least {fewest} px; cut it out with the whole mark in it.</source>
        <translation>Wzorzec ma {width} × {height} px, a bok musi mieć co najmniej {fewest} px; wytnij go tak, aby zawierał cały znaczek.</translation>
    </message>
    <message>
        <location filename="../plugin/photos/measure/messages.py" line="50"/>
        <source>All pixels of the template are alike; cut it out where the mark is.</source>
        <translation>Wszystkie piksele wzorca są jednakowe; wytnij go tam, gdzie jest znaczek.</translation>
    </message>
    <message>
        <location filename="../plugin/photos/measure/messages.py" line="67"/>
        <source>the surface around the best place is flat, so it has no extremum</source>
        <translation>powierzchnia wokół najlepszego miejsca jest płaska, więc nie ma ekstremum</translation>
    </message>
    <message>
        <location filename="../plugin/photos/measure/messages.py" line="68"/>
        <source>the surface around the best place is a saddle, so it has no extremum</source>
        <translation>powierzchnia wokół najlepszego miejsca jest siodłowa, więc nie ma ekstremum</translation>
    </message>
    <message>
        <location filename="../plugin/photos/measure/messages.py" line="69"/>
        <source>the extremum of the surface lies outside the pixels it was computed from</source>
        <translation>ekstremum powierzchni leży poza pikselami, z których ją obliczono</translation>
    </message>
    <message>
        <location filename="../plugin/photos/measure/messages.py" line="71"/>
        <source>the template is larger than the part of the photo around the mark</source>
        <translation>wzorzec jest większy niż fragment zdjęcia wokół znaczka</translation>
    </message>
    <message>
        <location filename="../plugin/photos/measure/messages.py" line="72"/>
        <source>the best correlation is {value:.2f} and at least {least:.2f} is asked for</source>
        <translation>największa korelacja wynosi {value:.2f}, a wymagana jest co najmniej {least:.2f}</translation>
    </message>
    <message>
        <location filename="../plugin/photos/measure/messages.py" line="73"/>
        <source>two places look nearly alike, with correlations of {best:.2f} and {second:.2f}</source>
        <translation>dwa miejsca wyglądają niemal tak samo, z korelacjami {best:.2f} i {second:.2f}</translation>
    </message>
    <message>
        <location filename="../plugin/photos/measure/messages.py" line="75"/>
        <source>the mark lies at the edge of the photo and is cut off</source>
        <translation>znaczek leży na brzegu zdjęcia i nie jest cały widoczny</translation>
    </message>
    <message>
        <location filename="../plugin/photos/measure/messages.py" line="77"/>
        <source>parts of the mark differ by {shift:.1f} px and at most {most:.1f} px is trusted: dirt, a scratch or no mark</source>
        <translation>części znaczka różnią się o {shift:.1f} px, a dopuszcza się najwyżej {most:.1f} px: zabrudzenie, rysa albo to nie znaczek</translation>
    </message>
    <message>
        <location filename="../plugin/photos/measure/messages.py" line="16"/>
        <source>The calibration {path} can&apos;t be read ({error}); check the path.</source>
        <translation>Nie można odczytać kalibracji {path} ({error}); sprawdź ścieżkę.</translation>
    </message>
    <message>
        <location filename="../plugin/photos/measure/messages.py" line="18"/>
        <source>{name} is neither a CSV with the columns mark, x_mm and y_mm nor a MeasuresCamera.xml of MicMac; choose one of these.</source>
        <translation>Plik {name} nie jest ani plikiem CSV z kolumnami mark, x_mm i y_mm, ani plikiem MeasuresCamera.xml z programu MicMac; wybierz jeden z nich.</translation>
    </message>
    <message>
        <location filename="../plugin/photos/measure/messages.py" line="20"/>
        <source>Row {row} of {name} has no mark with two numbers; complete or remove it.</source>
        <translation>Wiersz {row} pliku {name} nie zawiera znaczka z dwiema liczbami; uzupełnij go lub usuń.</translation>
    </message>
    <message>
        <location filename="../plugin/photos/measure/messages.py" line="21"/>
        <source>{name} has the mark &apos;{mark}&apos; twice; give every mark a name of its own.</source>
        <translation>Plik {name} zawiera znaczek „{mark}” dwa razy; nadaj każdemu znaczkowi osobną nazwę.</translation>
    </message>
    <message>
        <location filename="../plugin/photos/measure/messages.py" line="22"/>
        <source>{name} holds no marks; a calibration has one row with mark, x_mm and y_mm for each.</source>
        <translation>Plik {name} nie zawiera znaczków; kalibracja ma dla każdego jeden wiersz z mark, x_mm i y_mm.</translation>
    </message>
    <message>
        <location filename="../plugin/photos/measure/messages.py" line="24"/>
        <source>The marks of the calibration are {span:g} mm apart and a photo has {least:g} to {most:g} mm; give millimetres.</source>
        <translation>Odległość między znaczkami kalibracji wynosi {span:g} mm, a na zdjęciu jest to od {least:g} do {most:g} mm; podaj milimetry.</translation>
    </message>
    <message>
        <location filename="../plugin/photos/measure/messages.py" line="26"/>
        <source>The calibration has too few marks: {count}, and the {model} model needs {least}; complete it or use another model.</source>
        <translation>Kalibracja ma za mało znaczków: {count}, a model {model} wymaga {least}; uzupełnij ją albo użyj innego modelu.</translation>
    </message>
    <message>
        <location filename="../plugin/photos/measure/messages.py" line="93"/>
        <source>Marks measured or given: {count}, and the {model} model needs {least}; measure the others by hand and give them as positions with their measurement off.</source>
        <translation>Znaczki zmierzone lub podane: {count}, a model {model} wymaga {least}; zmierz pozostałe ręcznie i podaj je jako położenia z wyłączonym pomiarem.</translation>
    </message>
    <message>
        <location filename="../plugin/photos/measure/messages.py" line="96"/>
        <source>The marks are at the same place or on one line, so the {model} model can&apos;t be determined; give further marks.</source>
        <translation>Znaczki są w jednym miejscu albo na jednej prostej, więc nie można wyznaczyć modelu {model}; podaj dalsze znaczki.</translation>
    </message>
    <message>
        <location filename="../plugin/photos/measure/messages.py" line="52"/>
        <source>All pixels of {name} are alike, so it shows no marks; scan the photo again.</source>
        <translation>Wszystkie piksele rastra {name} są jednakowe, więc nie widać na nim znaczków; zeskanuj zdjęcie ponownie.</translation>
    </message>
    <message>
        <location filename="../plugin/photos/measure/messages.py" line="54"/>
        <source>No mark was found in {name} ({why}); give positions, another kind of template, or a template cut out of the photo.</source>
        <translation>Na zdjęciu {name} nie znaleziono znaczka ({why}); podaj położenia, inny rodzaj wzorca albo wzorzec wycięty ze zdjęcia.</translation>
    </message>
    <message>
        <location filename="../plugin/photos/measure/messages.py" line="36"/>
        <source>The positions name a mark &apos;{mark}&apos; that the calibration does not have ({marks}); rename it.</source>
        <translation>Położenia wymieniają znaczek „{mark}”, którego kalibracja nie zawiera ({marks}); zmień jego nazwę.</translation>
    </message>
    <message>
        <location filename="../plugin/photos/measure/messages.py" line="42"/>
        <source>The positions lie up to {worst:.0f} mm from where the calibration places them; check their names and the calibration.</source>
        <translation>Położenia leżą do {worst:.0f} mm od miejsc wynikających z kalibracji; sprawdź ich nazwy i kalibrację.</translation>
    </message>
    <message>
        <location filename="../plugin/photos/measure/messages.py" line="38"/>
        <source>The position of &apos;{mark}&apos; lies outside the photo; digitise it on the photo as QGIS shows it without a world file, or with the one that the photo has.</source>
        <translation>Położenie „{mark}” leży poza zdjęciem; zdigitalizuj je na zdjęciu tak, jak pokazuje je QGIS bez pliku world albo z plikiem, który zdjęcie ma.</translation>
    </message>
    <message>
        <location filename="../plugin/photos/measure/messages.py" line="49"/>
        <source>The template is {side:.1f} mm wide and the search area {search:.1f} mm; cut it out smaller or search further.</source>
        <translation>Wzorzec ma szerokość {side:.1f} mm, a obszar szukania {search:.1f} mm; wytnij mniejszy wzorzec albo szukaj dalej.</translation>
    </message>
    <message>
        <location filename="../plugin/photos/measure/messages.py" line="57"/>
        <source>Marks were found in the photo, but not where the positions say; each was looked for on its own there.</source>
        <translation>Na zdjęciu znaleziono znaczki, ale nie tam, gdzie wskazują położenia; każdego szukano tam osobno.</translation>
    </message>
    <message>
        <location filename="../plugin/photos/measure/messages.py" line="59"/>
        <source>The photo&apos;s orientation in the scanner is unknown, so it is taken as upright and not mirrored; give the positions of three marks if that is wrong.</source>
        <translation>Nic nie mówi, jak zdjęcie leży w skanerze, więc przyjęto, że leży prosto i nie jest odbite lustrzanie; jeśli to błąd, podaj położenia trzech znaczków.</translation>
    </message>
    <message>
        <location filename="../plugin/photos/measure/messages.py" line="70"/>
        <source>nothing around the position looks like a mark</source>
        <translation>wokół położenia nic nie wygląda jak znaczek</translation>
    </message>
    <message>
        <location filename="../plugin/photos/measure/messages.py" line="80"/>
        <source>no possible marks in the photo are arranged as in the calibration</source>
        <translation>żadne miejsca na zdjęciu podobne do znaczków nie leżą zgodnie z kalibracją</translation>
    </message>
    <message>
        <location filename="../plugin/photos/measure/messages.py" line="79"/>
        <source>it would lie outside the photo</source>
        <translation>leżałby poza zdjęciem</translation>
    </message>
    <message>
        <location filename="../plugin/photos/measure/messages.py" line="83"/>
        <source>it was found at the same place as &apos;{other}&apos;</source>
        <translation>znaleziono go w tym samym miejscu co „{other}”</translation>
    </message>
    <message>
        <location filename="../plugin/photos/measure/messages.py" line="84"/>
        <source>it lies {worst:.2f} mm from where the other marks place it and {limit:.2f} mm is allowed</source>
        <translation>leży {worst:.2f} mm od miejsca wynikającego z pozostałych znaczków, a dopuszcza się najwyżej {limit:.2f} mm</translation>
    </message>
    <message>
        <location filename="../plugin/photos/measure/messages.py" line="89"/>
        <source>the marks lie up to {worst:.2f} mm from where the calibration places them, {limit:.2f} mm is allowed, and it is unknown which is wrong</source>
        <translation>znaczki leżą do {worst:.2f} mm od miejsc wynikających z kalibracji, dopuszcza się najwyżej {limit:.2f} mm i nie można ustalić, który jest błędny</translation>
    </message>
    <message>
        <location filename="../plugin/photos/measure/messages.py" line="98"/>
        <source>The {model} model needs all of the {count} marks, so the residuals are 0 and say nothing about its accuracy; measure more marks or use a simpler model.</source>
        <translation>Model {model} wykorzystuje wszystkie swoje znaczki ({count}), więc odchyłki są zerowe i nic nie mówią o jego dokładności; zmierz więcej znaczków albo użyj prostszego modelu.</translation>
    </message>
    <message>
        <location filename="../plugin/photos/measure/messages.py" line="74"/>
        <source>the surface&apos;s extremum leads away from where the mark was found</source>
        <translation>ekstremum powierzchni prowadzi z dala od miejsca, w którym znaleziono znaczek</translation>
    </message>
    <message>
        <location filename="../plugin/photos/measure/messages.py" line="82"/>
        <source>only {count} possible marks are arranged as in the calibration, and without positions {least} are needed</source>
        <translation>liczba miejsc podobnych do znaczków i zgodnych z kalibracją wynosi tylko {count}, a bez położeń potrzeba {least}</translation>
    </message>
    <message>
        <location filename="../plugin/photos/measure/messages.py" line="100"/>
        <source>There is no transformation to write; give the positions of more marks.</source>
        <translation>Nie ma transformacji do zapisania; podaj położenia większej liczby znaczków.</translation>
    </message>
    <message>
        <location filename="../plugin/photos/measure/messages.py" line="102"/>
        <source>{name} has no transformation ({why}); its marks are in the output, but no parameters and no world file were written.</source>
        <translation>Raster {name} nie ma transformacji ({why}); jego znaczki są w wyniku, ale nie zapisano parametrów ani pliku world.</translation>
    </message>
    <message>
        <location filename="../plugin/photos/measure/messages.py" line="32"/>
        <source>The layer of positions has no field &apos;mark&apos;; add one and write the names of the calibration&apos;s marks into it.</source>
        <translation>Warstwa położeń nie ma pola „mark”; dodaj je i wpisz do niego nazwy znaczków kalibracji.</translation>
    </message>
    <message>
        <location filename="../plugin/photos/measure/messages.py" line="34"/>
        <source>The layer of positions has the mark &apos;{mark}&apos; twice; remove one of them.</source>
        <translation>Warstwa położeń zawiera znaczek „{mark}” dwa razy; usuń jeden z nich.</translation>
    </message>
    <message>
        <location filename="../plugin/photos/measure/messages.py" line="33"/>
        <source>The layer of positions holds no point with a name in its field &apos;mark&apos;; digitise some.</source>
        <translation>Warstwa położeń nie zawiera punktu z nazwą w polu „mark”; zdigitalizuj takie punkty.</translation>
    </message>
    <message>
        <location filename="../plugin/photos/measure/messages.py" line="112"/>
        <source>The layer {layer} has no field &apos;mark&apos;; choose layers of measured marks.</source>
        <translation>Warstwa {layer} nie ma pola „mark”; wybierz warstwy ze zmierzonymi znaczkami.</translation>
    </message>
    <message>
        <location filename="../plugin/photos/measure/messages.py" line="121"/>
        <source>The pixel size is not known, so the distances are given in pixels only; give the pixel size, or layers with the fields x_mm and y_mm.</source>
        <translation>Wielkość piksela nie jest znana, więc odległości podano tylko w pikselach; podaj wielkość piksela albo warstwy z polami x_mm i y_mm.</translation>
    </message>
    <message>
        <location filename="../plugin/photos/measure/messages.py" line="15"/>
        <source>No calibration is given; choose the file with the calibrated marks of the camera.</source>
        <translation>Nie podano kalibracji; wybierz plik z kalibrowanymi znaczkami kamery.</translation>
    </message>
    <message>
        <location filename="../plugin/photos/measure/messages.py" line="7"/>
        <source>The side of the mean is {size:g} px; give an odd number from 3 to {most:g}.</source>
        <translation>Bok średniej wynosi {size:g} px; podaj liczbę nieparzystą od 3 do {most:g}.</translation>
    </message>
    <message>
        <location filename="../plugin/photos/measure/messages.py" line="9"/>
        <source>The standard deviation of the Gaussian is {size:g} px; give one above 0 and up to {most:g}.</source>
        <translation>Odchylenie standardowe filtra Gaussa wynosi {size:g} px; podaj wartość większą niż 0 i najwyżej {most:g}.</translation>
    </message>
    <message>
        <location filename="../plugin/imagery/messages.py" line="90"/>
        <source>{path} can&apos;t be written; choose another folder, or make room on the disk.</source>
        <translation>Nie można zapisać {path}; wybierz inny katalog albo zwolnij miejsce na dysku.</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/measure/messages.py" line="10"/>
        <source>{name} is not a points file of QGIS&apos;s georeferencer (its header names no mapX, mapY and sourceX or pixelX); choose one, or a point layer with the fields column and row.</source>
        <translation>{name} nie jest plikiem punktów georeferencera QGIS (jego nagłówek nie zawiera mapX, mapY oraz sourceX lub pixelX); wybierz taki plik albo warstwę punktową z polami column i row.</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/measure/messages.py" line="13"/>
        <source>Line {line} of {name} can&apos;t be read; correct or remove it.</source>
        <translation>Nie można odczytać wiersza {line} pliku {name}; popraw go lub usuń.</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/measure/messages.py" line="15"/>
        <source>{name} names no coordinate reference system, as files from before QGIS 3.26 do; set the points&apos; reference system.</source>
        <translation>Plik {name} nie podaje układu współrzędnych, jak pliki sprzed QGIS 3.26; ustaw układ współrzędnych punktów.</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/measure/messages.py" line="17"/>
        <source>The point layer has no field &apos;{field}&apos;; it needs column and row, the place of each point in the image in pixels.</source>
        <translation>Warstwa punktów nie ma pola „{field}”; wymagane są column i row, miejsce każdego punktu na obrazie w pikselach.</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/measure/messages.py" line="7"/>
        <source>There are no points to fit a model to; measure some, or choose another layer.</source>
        <translation>Nie ma punktów do dopasowania modelu; zmierz je albo wybierz inną warstwę.</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/measure/messages.py" line="19"/>
        <source>Point {name} is left out: {why}</source>
        <translation>Punkt {name} pominięto: {why}</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/measure/messages.py" line="21"/>
        <source>its place in the image or on the ground is missing.</source>
        <translation>brakuje jego miejsca na obrazie lub w terenie.</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/measure/messages.py" line="22"/>
        <source>its role &apos;{role}&apos; is neither control nor check.</source>
        <translation>jego rola „{role}” nie jest ani control, ani check.</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/measure/messages.py" line="18"/>
        <source>Points that are switched off in the georeferencer and left out: {count}.</source>
        <translation>Punkty wyłączone w georeferencerze i pominięte: {count}.</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/measure/messages.py" line="56"/>
        <source>Some points have no height, which the model {model} needs; add a field z or choose a terrain model, or take polynomial_2d.</source>
        <translation>Niektóre punkty nie mają wysokości, której wymaga model {model}; dodaj pole z, wybierz NMT albo użyj polynomial_2d.</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/measure/messages.py" line="62"/>
        <source>The control points lie on one line, so the model {model} can&apos;t be fitted; add points to both sides of it.</source>
        <translation>Fotopunkty leżą na jednej prostej, więc nie można dopasować modelu {model}; dodaj punkty po obu jej stronach.</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/measure/messages.py" line="64"/>
        <source>The control points lie on one plane, so the terms in Z of the model {model} can&apos;t be determined; add points of other heights, or take polynomial_2d or rpc_bias.</source>
        <translation>Fotopunkty leżą na jednej płaszczyźnie, więc nie można wyznaczyć wyrazów z Z modelu {model}; dodaj punkty na innych wysokościach albo użyj polynomial_2d lub rpc_bias.</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/measure/messages.py" line="67"/>
        <source>{count} control points contradict the others, and too few are left to fit the model {model}; check the points, above all that columns and rows are not interchanged.</source>
        <translation>{count} {count:fotopunkt jest sprzeczny|fotopunkty są sprzeczne|fotopunktów jest sprzecznych} z innymi, a pozostałych jest za mało, aby dopasować model {model}; sprawdź punkty, a przede wszystkim, czy nie zamieniono kolumn z wierszami.</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/measure/messages.py" line="74"/>
        <source>The control points leave {share:.0%} of the image outside their outline; what lies there is extrapolated, so add points towards the image&apos;s corners.</source>
        <translation>Fotopunkty pozostawiają {share:.0%} obrazu poza swoim obrysem; to, co tam leży, jest ekstrapolowane, więc dodaj punkty bliżej narożników obrazu.</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/measure/messages.py" line="80"/>
        <source>There are no check points, so the errors given are those of the fit on its own points; set roles or a share of check points.</source>
        <translation>Nie ma punktów kontrolnych, więc podane błędy są błędami dopasowania na jego własnych punktach; ustaw role albo udział punktów kontrolnych.</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/measure/messages.py" line="84"/>
        <source>The fit did not converge within {iterations} iterations, so the points are too few or too noisy for it; add points or choose a model with fewer unknowns.</source>
        <translation>Dopasowanie nie ustaliło się w ciągu {iterations} iteracji, więc punktów jest za mało albo są zbyt niedokładne; dodaj punkty albo wybierz model o mniejszej liczbie niewiadomych.</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/measure/messages.py" line="87"/>
        <source>The points hardly determine the model (condition {condition:.0e}): between them it may oscillate, so trust the check points only or choose a lower order.</source>
        <translation>Punkty słabo wyznaczają model (uwarunkowanie {condition:.0e}): może on między nimi falować, więc ufaj tylko punktom kontrolnym albo wybierz niższy stopień.</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/measure/messages.py" line="102"/>
        <source>The model polynomial_2d ignores heights and can&apos;t be written as RPC or used for orthorectification; fit a model in space.</source>
        <translation>Model polynomial_2d nie uwzględnia wysokości i nie można go zapisać jako RPC ani użyć do ortorektyfikacji; dopasuj model przestrzenny.</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/measure/messages.py" line="96"/>
        <source>The image has no RPC of its own; give the file that came with it, or choose a model that needs none.</source>
        <translation>Obraz nie ma własnego RPC; podaj plik dostarczony z obrazem albo wybierz model, który go nie wymaga.</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/measure/messages.py" line="97"/>
        <source>{name} holds no complete RPC; get the file again from the image&apos;s vendor.</source>
        <translation>Plik {name} nie zawiera kompletnego RPC; pobierz go ponownie od dostawcy obrazu.</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/measure/messages.py" line="104"/>
        <source>No RPC is written: {why}</source>
        <translation>Nie zapisano RPC: {why}</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/measure/messages.py" line="106"/>
        <source>The RPC follows the model to {rms:.2g} px (root mean square) and {largest:.2g} px at most, over the whole image and heights of {low:.0f} to {high:.0f} m.</source>
        <translation>RPC odtwarza model z dokładnością do {rms:.2g} px (błąd średniokwadratowy) i najwyżej {largest:.2g} px, na całym obrazie i dla wysokości od {low:.0f} do {high:.0f} m.</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/measure/messages.py" line="111"/>
        <source>The image is taken as a part of the scene that the RPC describes, from column {column:.0f} and row {row:.0f} on.</source>
        <translation>Obraz przyjęto jako część sceny opisanej przez RPC, od kolumny {column:.0f} i wiersza {row:.0f}.</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/measure/messages.py" line="114"/>
        <source>{name} is not a sensor model file; choose one that Fit sensor model has written.</source>
        <translation>{name} nie jest plikiem modelu sensora; wybierz plik zapisany przez fitsensormodel.</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/measure/messages.py" line="116"/>
        <source>{name} is of version {version}, which this version of Seam Inspector does not read; fit the model again.</source>
        <translation>Plik {name} ma wersję {version}, której ta wersja wtyczki Seam Inspector nie odczytuje; dopasuj model ponownie.</translation>
    </message>
    <message>
        <location filename="../plugin/imagery/messages.py" line="46"/>
        <source>PROJ has no grid to convert heights of {vertical} to the ellipsoid; install it (projsync) or give heights above the ellipsoid.</source>
        <translation>PROJ nie ma siatki do przeliczenia wysokości {vertical} na elipsoidę; zainstaluj ją (projsync) albo podaj wysokości nad elipsoidą.</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/measure/messages.py" line="180"/>
        <source>{name} does not say what its heights refer to; they are taken as above the ellipsoid. Heights above sea level differ by up to 100 m: choose egm96 or egm2008 for these.</source>
        <translation>Nie podano, do czego odnoszą się wysokości ({name}); przyjęto wysokości nad elipsoidą. Wysokości nad poziomem morza różnią się nawet o 100 m: jeśli to takie, wybierz egm96 lub egm2008.</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/measure/messages.py" line="183"/>
        <source>The heights of {name} ({vertical}) are converted to the ellipsoid: {least:.1f} to {most:.1f} m are added.</source>
        <translation>Wysokości ({name}, {vertical}) przeliczono na elipsoidę: dodano od {least:.1f} do {most:.1f} m.</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/measure/messages.py" line="194"/>
        <source>The terrain model {name} does not cover the image, which lies at {west:.4f} to {east:.4f} degrees east, {south:.4f} to {north:.4f} degrees north; choose one that does.</source>
        <translation>NMT {name} nie pokrywa obrazu, który leży od {west:.4f} do {east:.4f} stopnia długości wschodniej i od {south:.4f} do {north:.4f} stopnia szerokości północnej; wybierz NMT, który go pokrywa.</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/measure/messages.py" line="197"/>
        <source>The terrain model {name} has no heights under {share:.1%} of the image (holes, or it ends there); the orthoimage is empty there, so fill or extend the terrain model.</source>
        <translation>NMT {name} nie ma wysokości pod {share:.1%} obrazu (luki albo tam się kończy); ortoobraz jest tam pusty, więc uzupełnij lub rozszerz NMT.</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/measure/messages.py" line="200"/>
        <source>The terrain model {name} has {count} million pixels under the image, but at most {most} million can be used; resample it, 10 to 30 m work best.</source>
        <translation>NMT {name} ma pod obrazem {count} mln pikseli, a największa dopuszczalna liczba to {most} mln; przepróbkuj go, najlepsze są oczka od 10 do 30 m.</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/measure/messages.py" line="209"/>
        <source>The pixel size is {size}; give a positive number of map units.</source>
        <translation>Wielkość piksela wynosi {size}; podaj dodatnią liczbę jednostek mapy.</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/measure/messages.py" line="210"/>
        <source>An extent is given but no reference system; choose the orthoimage&apos;s reference system.</source>
        <translation>Podano zasięg, ale nie podano układu współrzędnych; wybierz układ współrzędnych ortoobrazu.</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/measure/messages.py" line="211"/>
        <source>The extent lies outside the image; choose one that overlaps it.</source>
        <translation>Zasięg leży poza obrazem; wybierz taki, który na niego zachodzi.</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/measure/messages.py" line="212"/>
        <source>The orthoimage would have {width} x {height} px; choose larger pixels or a smaller extent.</source>
        <translation>Ortoobraz miałby {width} × {height} px; wybierz większe piksele albo mniejszy zasięg.</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/measure/messages.py" line="213"/>
        <source>The orthoimage could not be written ({error}); check the folder and the free space.</source>
        <translation>Nie udało się zapisać ortoobrazu ({error}); sprawdź katalog i wolne miejsce.</translation>
    </message>
    <message>
        <location filename="../plugin/imagery/messages.py" line="89"/>
        <source>The work was cancelled; nothing was written.</source>
        <translation>Pracę anulowano; niczego nie zapisano.</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/measure/messages.py" line="235"/>
        <source>No model could be fitted and judged; the table says why for each, so measure more points or correct them.</source>
        <translation>Nie udało się dopasować i ocenić żadnego modelu; przyczynę dla każdego podaje tabela, więc zmierz więcej punktów albo je popraw.</translation>
    </message>
    <message>
        <location filename="../plugin/noise/report.py" line="139"/>
        <source>window</source>
        <translation>okno</translation>
    </message>
    <message>
        <source>verdict, cause, observer</source>
        <translation>ocena, przyczyna, obserwator</translation>
    </message>
    <message>
        <location filename="../plugin/seams/measure/window/window_tables.py" line="91"/>
        <source>ratio {level}</source>
        <translation>stosunek {level}</translation>
    </message>
    <message>
        <location filename="../plugin/noise/report.py" line="139"/>
        <source>raster</source>
        <translation>raster</translation>
    </message>
    <message>
        <source>detail, level</source>
        <translation>detale, poziom</translation>
    </message>
    <message>
        <source>Relative variances</source>
        <translation>Wariancje względne</translation>
    </message>
    <message>
        <location filename="../plugin/seams/report/flagged_windows.py" line="71"/>
        <source>cause: {cause}</source>
        <translation>przyczyna: {cause}</translation>
    </message>
    <message>
        <location filename="../plugin/seams/report/flagged_windows.py" line="76"/>
        <source>observer: {word}</source>
        <translation>obserwator: {word}</translation>
    </message>
    <message>
        <location filename="../plugin/seams/report/flagged_windows.py" line="84"/>
        <source>hard-cut composite</source>
        <translation>kompozycja z ostrym cięciem</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/report.py" line="43"/>
        <source>Blunders</source>
        <translation>Błędy grube</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/report.py" line="61"/>
        <source>Column (px)</source>
        <translation>Kolumna (px)</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/report.py" line="61"/>
        <source>Row (px)</source>
        <translation>Wiersz (px)</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/report.py" line="86"/>
        <source>Mean error on points not used in the fit (m)</source>
        <translation>Błąd średni na punktach nieużytych w dopasowaniu (m)</translation>
    </message>
    <message>
        <location filename="../plugin/noise/noise_summary.py" line="23"/>
        <source>low</source>
        <translation>mały</translation>
    </message>
    <message>
        <location filename="../plugin/noise/noise_summary.py" line="25"/>
        <source>moderate</source>
        <translation>umiarkowany</translation>
    </message>
    <message>
        <location filename="../plugin/noise/noise_summary.py" line="26"/>
        <source>strong</source>
        <translation>silny</translation>
    </message>
    <message>
        <location filename="../plugin/noise/noise_summary.py" line="27"/>
        <source>not measurable</source>
        <translation>niemierzalne</translation>
    </message>
    <message>
        <source>Random noise</source>
        <translation>Szum losowy</translation>
    </message>
    <message>
        <source>Windows by their random noise: {counts}.</source>
        <translation>Okna według szumu losowego: {counts}.</translation>
    </message>
    <message>
        <source>Relative variance of the details by level, 1 the finest. It rises from level to level in an image with little random noise; noise lifts level 1 above level 2 and, where it is strong, level 2 above level 3.</source>
        <translation>Wariancja względna detali według poziomów, poziom 1 jest najdokładniejszy. W obrazie o małym szumie losowym rośnie z poziomu na poziom; szum podnosi poziom 1 ponad poziom 2, a gdy jest silny, także poziom 2 ponad poziom 3.</translation>
    </message>
    <message>
        <location filename="../plugin/noise/report.py" line="61"/>
        <source>group</source>
        <translation>grupa</translation>
    </message>
    <message>
        <source>pixel</source>
        <translation>piksel</translation>
    </message>
    <message>
        <source>least sigma (DN)</source>
        <translation>najmniejsza sigma (DN)</translation>
    </message>
    <message>
        <source>mean</source>
        <translation>średnia</translation>
    </message>
    <message>
        <source>largest</source>
        <translation>największa</translation>
    </message>
    <message>
        <location filename="../plugin/noise/report.py" line="139"/>
        <source>noise</source>
        <translation>szum</translation>
    </message>
    <message>
        <location filename="../plugin/noise/report.py" line="140"/>
        <source>sigma (DN)</source>
        <translation>sigma (DN)</translation>
    </message>
    <message>
        <location filename="../plugin/noise/report.py" line="141"/>
        <source>detail {level}</source>
        <translation>detale {level}</translation>
    </message>
    <message>
        <location filename="../plugin/noise/report.py" line="142"/>
        <source>kurtosis by level</source>
        <translation>kurtoza według poziomów</translation>
    </message>
    <message>
        <location filename="../plugin/noise/report.py" line="142"/>
        <source>column, row</source>
        <translation>kolumna, wiersz</translation>
    </message>
    <message>
        <location filename="../plugin/noise/report.py" line="142"/>
        <source>note</source>
        <translation>uwaga</translation>
    </message>
    <message>
        <source>Sigma is the median absolute value of the finest diagonal component divided by 0.6745, in DN. Fine texture adds to it, so compare it between images of the same ground.</source>
        <translation>Sigma to mediana wartości bezwzględnych najdrobniejszego detalu diagonalnego podzielona przez 0,6745, w DN. Drobna tekstura ją powiększa, więc porównuj ją między obrazami tego samego terenu.</translation>
    </message>
    <message>
        <location filename="../plugin/resolution/line_layers.py" line="165"/>
        <source>Add a bar group</source>
        <translation>Dodaj grupę pasków</translation>
    </message>
    <message>
        <location filename="../plugin/seams/words.py" line="125"/>
        <source>blur</source>
        <translation>rozmycie</translation>
    </message>
    <message>
        <location filename="../plugin/seams/words.py" line="136"/>
        <source>feathering</source>
        <translation>wtapianie</translation>
    </message>
    <message>
        <location filename="../plugin/seams/words.py" line="157"/>
        <source>narrowed histogram</source>
        <translation>zawężony histogram</translation>
    </message>
    <message>
        <location filename="../plugin/seams/words.py" line="164"/>
        <source>gamma</source>
        <translation>gamma</translation>
    </message>
    <message>
        <location filename="../plugin/seams/words.py" line="173"/>
        <source>clipping</source>
        <translation>obcięcie</translation>
    </message>
    <message>
        <location filename="../plugin/seams/words.py" line="184"/>
        <source>colour shift</source>
        <translation>przesunięcie barw</translation>
    </message>
    <message>
        <location filename="../plugin/seams/words.py" line="191"/>
        <source>misregistration</source>
        <translation>wzajemne przesunięcie</translation>
    </message>
    <message>
        <location filename="../plugin/seams/words.py" line="271"/>
        <source>unclear</source>
        <translation>niejasne</translation>
    </message>
    <message>
        <location filename="../plugin/seams/words.py" line="126"/>
        <source>The mosaic is less sharp than its sources, beyond what tone and feathering explain.</source>
        <translation>Ortofotomapa jest mniej ostra niż jej ortoobrazy źródłowe, bardziej niż wyjaśniają to tonacja i wtapianie.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/words.py" line="158"/>
        <source>The range of grey values was narrowed by a linear function.</source>
        <translation>Funkcja liniowa ścisnęła jasności pikseli (zawężenie histogramu).</translation>
    </message>
    <message>
        <location filename="../plugin/seams/words.py" line="165"/>
        <source>Grey values were changed by a power function.</source>
        <translation>Funkcja potęgowa zmieniła jasności pikseli.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/words.py" line="174"/>
        <source>Highlights or shadows were cut off at the limits.</source>
        <translation>Światła lub cienie doprowadzono do granic zakresu.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/words.py" line="265"/>
        <source>No step of production was found that took contrast away.</source>
        <translation>Nie znaleziono etapu produkcji, który odebrał kontrast.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/words.py" line="272"/>
        <source>What was measured does not point to one cause.</source>
        <translation>Wyniki pomiaru nie wskazują jednej przyczyny.</translation>
    </message>
    <message>
        <source>Pictures</source>
        <translation>Obrazy znaczków</translation>
    </message>
    <message>
        <source>Interior orientation of {name}</source>
        <translation>Orientacja wewnętrzna: {name}</translation>
    </message>
    <message>
        <source>Mark</source>
        <translation>Znaczek</translation>
    </message>
    <message>
        <source>Column, px</source>
        <translation>Kolumna, px</translation>
    </message>
    <message>
        <source>Row, px</source>
        <translation>Wiersz, px</translation>
    </message>
    <message>
        <source>x, mm</source>
        <translation>x, mm</translation>
    </message>
    <message>
        <source>y, mm</source>
        <translation>y, mm</translation>
    </message>
    <message>
        <source>Correlation</source>
        <translation>Korelacja</translation>
    </message>
    <message>
        <source>Status</source>
        <translation>Stan</translation>
    </message>
    <message>
        <source>Reason</source>
        <translation>Przyczyna</translation>
    </message>
    <message>
        <source>Pixel centres are at .5: the first pixel reaches from 0 to 1. Millimetres: x to the right, y upwards.</source>
        <translation>Środki pikseli mają końcówkę ,5: pierwszy piksel sięga od 0 do 1. Milimetry: x w prawo, y w górę.</translation>
    </message>
    <message>
        <source>to millimetres</source>
        <translation>na milimetry</translation>
    </message>
    <message>
        <source>to pixels</source>
        <translation>na piksele</translation>
    </message>
    <message>
        <source>Model: {model}, marks: {marks}, degrees of freedom: {redundancy}.</source>
        <translation>Model {model}, znaczki: {marks}, stopnie swobody: {redundancy}.</translation>
    </message>
    <message>
        <source>The photo is rotated by {turned} degrees clockwise{mirrored}, according to: {evidence}.</source>
        <translation>Zdjęcie jest obrócone o {turned}° zgodnie z ruchem wskazówek zegara{mirrored}, co ustalono na podstawie {evidence}.</translation>
    </message>
    <message>
        <source> and mirrored</source>
        <translation> i odbite lustrzanie</translation>
    </message>
    <message>
        <location filename="../plugin/photos/report.py" line="125"/>
        <source>correlation {value:.2f}</source>
        <translation>korelacja {value:.2f}</translation>
    </message>
    <message>
        <location filename="../plugin/seams/charts/calibration_chart.py" line="39"/>
        <source>windows flagged by mistake (1 - specificity)</source>
        <translation>okna oznaczone niepotrzebnie (1 - swoistość)</translation>
    </message>
    <message>
        <location filename="../plugin/seams/charts/calibration_chart.py" line="40"/>
        <source>visible losses flagged (sensitivity)</source>
        <translation>oznaczone widoczne straty (czułość)</translation>
    </message>
    <message>
        <location filename="../plugin/seams/charts/calibration_chart.py" line="42"/>
        <source>a guess</source>
        <translation>zgadywanie</translation>
    </message>
    <message>
        <location filename="../plugin/seams/charts/calibration_chart.py" line="62"/>
        <source>AUC {area:.3f} (95 %: {low:.3f} to {high:.3f})</source>
        <translation>AUC {area:.3f} (95 %: od {low:.3f} do {high:.3f})</translation>
    </message>
    <message>
        <location filename="../plugin/seams/charts/calibration_chart.py" line="67"/>
        <source>threshold {value:g}: {hits} of {seen}, by mistake {vain} of {unseen}</source>
        <translation>próg {value:g}: {hits} z {seen}, niepotrzebnie {vain} z {unseen}</translation>
    </message>
    <message>
        <location filename="../plugin/seams/charts/calibration_chart.py" line="82"/>
        <source>visible ({count})</source>
        <translation>widoczne ({count})</translation>
    </message>
    <message>
        <location filename="../plugin/seams/charts/calibration_chart.py" line="83"/>
        <source>invisible ({count})</source>
        <translation>niewidoczne ({count})</translation>
    </message>
    <message>
        <location filename="../plugin/seams/charts/calibration_chart.py" line="97"/>
        <source>standard {value:g}</source>
        <translation>standardowy {value:g}</translation>
    </message>
    <message>
        <location filename="../plugin/seams/charts/calibration_chart.py" line="101"/>
        <source>threshold {value:g}</source>
        <translation>próg {value:g}</translation>
    </message>
    <message>
        <location filename="../plugin/noise/charts.py" line="48"/>
        <source>bold curve in the red: noise</source>
        <translation>gruba krzywa w czerwonym polu: szum</translation>
    </message>
    <message>
        <location filename="../plugin/noise/charts.py" line="122"/>
        <source>mean and range of {count} windows</source>
        <translation>średnia i zakres {count} {count:okna|okien|okien}</translation>
    </message>
    <message>
        <location filename="../plugin/noise/charts.py" line="139"/>
        <source>Window {window}: {names}</source>
        <translation>Okno {window}: {names}</translation>
    </message>
    <message>
        <location filename="../plugin/resolution/distance_words.py" line="12"/>
        <source>along the flight</source>
        <translation>wzdłuż kierunku lotu</translation>
    </message>
    <message>
        <location filename="../plugin/resolution/distance_words.py" line="12"/>
        <source>across the flight</source>
        <translation>w poprzek kierunku lotu</translation>
    </message>
    <message>
        <location filename="../plugin/resolution/charts.py" line="34"/>
        <source>not resolved</source>
        <translation>nierozróżniona</translation>
    </message>
    <message>
        <location filename="../plugin/resolution/charts.py" line="35"/>
        <source>aliasing</source>
        <translation>aliasing</translation>
    </message>
    <message>
        <location filename="../plugin/resolution/charts.py" line="36"/>
        <source>not measured</source>
        <translation>niezmierzona</translation>
    </message>
    <message>
        <location filename="../plugin/seams/report/flagged_windows.py" line="144"/>
        <source>Window {number}: {verdict}</source>
        <translation>Okno {number}: {verdict}</translation>
    </message>
    <message>
        <source>{name} (mosaic)</source>
        <translation>{name} (ortofotomapa)</translation>
    </message>
    <message>
        <location filename="../plugin/seams/report/flagged_windows.py" line="174"/>
        <source>Observer: {word}.</source>
        <translation>Obserwator: {word}.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/report/flagged_windows.py" line="184"/>
        <source>against the sources</source>
        <translation>względem źródeł</translation>
    </message>
    <message>
        <location filename="../plugin/seams/report/flagged_windows.py" line="185"/>
        <source>against the hard-cut composite</source>
        <translation>względem kompozycji z ostrym cięciem</translation>
    </message>
    <message>
        <location filename="../plugin/seams/report/flagged_windows.py" line="186"/>
        <source>expected of a 50:50 feather</source>
        <translation>oczekiwany po wtapianiu 50:50</translation>
    </message>
    <message>
        <location filename="../plugin/seams/report/flagged_windows.py" line="205"/>
        <source>Sources that are not shown: {count}.</source>
        <translation>Niepokazane źródła: {count}.</translation>
    </message>
    <message>
        <location filename="../plugin/radiometry/words.py" line="17"/>
        <source>clipped at the dark end</source>
        <translation>obcięcie w cieniach</translation>
    </message>
    <message>
        <location filename="../plugin/radiometry/words.py" line="18"/>
        <source>clipped at the bright end</source>
        <translation>obcięcie w światłach</translation>
    </message>
    <message>
        <location filename="../plugin/radiometry/words.py" line="19"/>
        <source>histogram peak from mid-scale</source>
        <translation>odległość maksimum histogramu od środka skali</translation>
    </message>
    <message>
        <location filename="../plugin/radiometry/words.py" line="20"/>
        <source>contrast</source>
        <translation>kontrast</translation>
    </message>
    <message>
        <location filename="../plugin/noise/report.py" line="140"/>
        <source>signal to noise</source>
        <translation>stosunek sygnału do szumu</translation>
    </message>
    <message>
        <location filename="../plugin/radiometry/words.py" line="22"/>
        <source>colour balance</source>
        <translation>balans barw</translation>
    </message>
    <message>
        <location filename="../plugin/radiometry/words.py" line="23"/>
        <source>step at the seams</source>
        <translation>skok na liniach mozaikowania</translation>
    </message>
    <message>
        <location filename="../plugin/radiometry/words.py" line="24"/>
        <source>contrast beside the seams</source>
        <translation>kontrast przy liniach mozaikowania</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/paper/words.py" line="129"/>
        <source>passed</source>
        <translation>spełnione</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/paper/words.py" line="129"/>
        <source>failed</source>
        <translation>niespełnione</translation>
    </message>
    <message>
        <source>Radiometric acceptance</source>
        <translation>Odbiór radiometryczny</translation>
    </message>
    <message>
        <location filename="../plugin/radiometry/words.py" line="47"/>
        <source>{name}, window {window}</source>
        <translation>{name}, okno {window}</translation>
    </message>
    <message>
        <location filename="../plugin/noise/report.py" line="41"/>
        <source>image</source>
        <translation>obraz</translation>
    </message>
    <message>
        <source>Tonal balancing and feathering lower the step at the seams and take contrast away with it, so both have to be looked at together.</source>
        <translation>Wyrównanie tonalne i wtapianie zmniejszają skok na liniach mozaikowania, ale odbierają przy tym kontrast, więc oba trzeba oceniać razem.</translation>
    </message>
    <message>
        <source>Tonal unity and contrast</source>
        <translation>Jednolitość tonalna i kontrast</translation>
    </message>
    <message>
        <source>largest step at a seam</source>
        <translation>największy skok na linii mozaikowania</translation>
    </message>
    <message>
        <source>Available range: {low:g} to {high:g} DN.</source>
        <translation>Dostępny zakres: od {low:g} do {high:g} DN.</translation>
    </message>
    <message>
        <location filename="../plugin/radiometry/words.py" line="32"/>
        <source>between bands</source>
        <translation>między kanałami</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/report.py" line="104"/>
        <source>check</source>
        <translation>kontrola</translation>
    </message>
    <message>
        <source>result</source>
        <translation>wynik</translation>
    </message>
    <message>
        <location filename="../plugin/radiometry/words.py" line="65"/>
        <source>{least} to {most}</source>
        <translation>od {least} do {most}</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/paper/words.py" line="107"/>
        <source>at most {most}</source>
        <translation>najwyżej {most}</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/paper/acceptance_report.py" line="303"/>
        <source>at least {least}</source>
        <translation>co najmniej {least}</translation>
    </message>
    <message>
        <source>Signal to noise: areas of {side} x {side} px, spread over the image, whose mean lies in the middle half of the range and whose four quadrants have the same mean within their noise; mean over standard deviation of the quarter with the least noise.</source>
        <translation>Stosunek sygnału do szumu: obszary {side} × {side} px, rozłożone na obrazie, których średnia leży w środkowej połowie zakresu, a cztery ćwiartki mają tę samą średnią, o ile pozwala to stwierdzić ich szum; z ćwierci obszarów o najmniejszym szumie, średnia podzielona przez odchylenie standardowe.</translation>
    </message>
    <message>
        <source>Step at the seams: difference of the means {near} to {far} px on either side for every {station} px of seam, their median along each seam, the largest of all seams as a share of the image&apos;s largest value. Contrast beside the seams is the standard deviation of the same pixels, as a share of the range.</source>
        <translation>Skok na liniach mozaikowania: różnica średnich od {near} do {far} px po obu stronach, co {station} px linii, mediana wzdłuż każdej linii, największa ze wszystkich linii jako część największej wartości obrazu. Kontrast przy liniach mozaikowania to odchylenie standardowe tych samych pikseli jako część zakresu.</translation>
    </message>
    <message>
        <source>Property</source>
        <translation>Właściwość</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Wartość</translation>
    </message>
    <message>
        <source>Unknowns</source>
        <translation>Niewiadome</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/report.py" line="111"/>
        <source>{count}, held by priors</source>
        <translation>{count}, ograniczone wartościami a priori</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/fitsensormodel.py" line="42"/>
        <source>polynomials of the plane, as in a georeferencer, without heights</source>
        <translation>zwykły model wielomianowy 2D, jak w georeferencerze, bez wysokości</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/fitsensormodel.py" line="43"/>
        <source>polynomials of space, without physics</source>
        <translation>zwykły model wielomianowy 3D, nieparametryczny</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/fitsensormodel.py" line="44"/>
        <source>quotients of polynomials as in an RPC, without physics</source>
        <translation>ilorazowy model wielomianowy, jak RPC, nieparametryczny</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/fitsensormodel.py" line="46"/>
        <source>the direct linear transformation, without physics</source>
        <translation>przekształcenie rzutowe (DLT), nieparametryczne</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/fitsensormodel.py" line="47"/>
        <source>the parametric model of a line scanner</source>
        <translation>model parametryczny skanera liniowego</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/fitsensormodel.py" line="48"/>
        <source>the RPC that came with the image, corrected</source>
        <translation>RPC dostarczone z obrazem, z poprawką</translation>
    </message>
    <message>
        <source>Iterations</source>
        <translation>Iteracje</translation>
    </message>
    <message>
        <source>Standard deviation of a control point</source>
        <translation>Odchylenie standardowe fotopunktu</translation>
    </message>
    <message>
        <source>Image outside the control points&apos; outline</source>
        <translation>Część obrazu poza obrysem fotopunktów</translation>
    </message>
    <message>
        <source>Accuracy</source>
        <translation>Dokładność</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>Punkty</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/planinspection.py" line="48"/>
        <source>Count</source>
        <translation>Liczba</translation>
    </message>
    <message>
        <source>Mean X (m)</source>
        <translation>Średni X (m)</translation>
    </message>
    <message>
        <source>Mean Y (m)</source>
        <translation>Średni Y (m)</translation>
    </message>
    <message>
        <source>Largest X (m)</source>
        <translation>Największy X (m)</translation>
    </message>
    <message>
        <source>Largest Y (m)</source>
        <translation>Największy Y (m)</translation>
    </message>
    <message>
        <source>Mean column (px)</source>
        <translation>Średni kolumny (px)</translation>
    </message>
    <message>
        <source>Mean row (px)</source>
        <translation>Średni wiersza (px)</translation>
    </message>
    <message>
        <source>Mean errors are root mean squares. Only check points, which were not used in the fit, show how accurate the image is.</source>
        <translation>Błędy średnie to błędy średniokwadratowe. Tylko punkty kontrolne, które nie brały udziału w dopasowaniu, mówią, jak dokładny będzie obraz.</translation>
    </message>
    <message>
        <source>Model minus measured in the image, enlarged; beyond the shaded outline the model extrapolates.</source>
        <translation>Model minus pomiar na obrazie, w powiększeniu; zacieniony obrys obejmuje to, co nie jest ekstrapolowane.</translation>
    </message>
    <message>
        <source>Point</source>
        <translation>Punkt</translation>
    </message>
    <message>
        <source>Role</source>
        <translation>Rola</translation>
    </message>
    <message>
        <source>Blunder</source>
        <translation>Błąd gruby</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/report.py" line="104"/>
        <source>control</source>
        <translation>fotopunkt</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/report.py" line="106"/>
        <source>yes</source>
        <translation>tak</translation>
    </message>
    <message>
        <source>Sensor model: {name}</source>
        <translation>Model sensora: {name}</translation>
    </message>
    <message>
        <source>Each point was predicted by a fit to all others (leave-one-out), since check points are few.</source>
        <translation>Każdy punkt przewidziano z dopasowania do wszystkich pozostałych (leave-one-out), ponieważ punktów kontrolnych jest mało.</translation>
    </message>
    <message>
        <source>Errors are those of check points, which were not used in the fit.</source>
        <translation>Błędy są błędami punktów kontrolnych, które nie brały udziału w dopasowaniu.</translation>
    </message>
    <message>
        <source>The recommended model stands out.</source>
        <translation>Zalecany model jest wyróżniony.</translation>
    </message>
    <message>
        <source>Table</source>
        <translation>Tabela</translation>
    </message>
    <message>
        <source>Judged on</source>
        <translation>Podstawa oceny</translation>
    </message>
    <message>
        <source>Mean errors are root mean squares.</source>
        <translation>Błędy średnie to błędy średniokwadratowe.</translation>
    </message>
    <message>
        <source>Not fitted, or not to be trusted</source>
        <translation>Niedopasowane lub niewiarygodne</translation>
    </message>
    <message>
        <source>Why</source>
        <translation>Dlaczego</translation>
    </message>
    <message>
        <source>Sensor models compared</source>
        <translation>Porównanie modeli sensora</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/report.py" line="146"/>
        <source>unknown</source>
        <translation>nieznane</translation>
    </message>
    <message>
        <location filename="../plugin/seams/words.py" line="36"/>
        <source>Significant loss.</source>
        <translation>Istotna strata.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/window_summary.py" line="211"/>
        <source>Detail at level 1 is {percent} % of the sources&apos; and {composite} % of their composite&apos;s</source>
        <translation>Detale na poziomie 1 to {percent} % detali ortoobrazów i {composite} % detali ich kompozycji</translation>
    </message>
    <message>
        <location filename="../plugin/seams/window_summary.py" line="209"/>
        <source>Detail at level 1 is {percent} % of the sources&apos;</source>
        <translation>Detale na poziomie 1 to {percent} % detali ortoobrazów</translation>
    </message>
    <message>
        <location filename="../plugin/seams/words.py" line="128"/>
        <source>the mosaic is blurred to {value} % of their sharpness</source>
        <translation>ortofotomapa jest rozmyta do {value} % ich ostrości</translation>
    </message>
    <message>
        <location filename="../plugin/seams/words.py" line="160"/>
        <source>the histogram is narrowed, gain {value}</source>
        <translation>histogram jest zawężony, wzmocnienie {value}</translation>
    </message>
    <message>
        <location filename="../plugin/seams/words.py" line="167"/>
        <source>grey values are bent, gamma {value}</source>
        <translation>jasności są zmienione potęgowo, gamma {value}</translation>
    </message>
    <message>
        <location filename="../plugin/seams/words.py" line="176"/>
        <source>{value} % of the pixels are clipped</source>
        <translation>{value} % pikseli jest obciętych</translation>
    </message>
    <message>
        <location filename="../plugin/seams/words.py" line="187"/>
        <source>the colours are shifted, gains differ by a factor of {value}</source>
        <translation>barwy są przesunięte, wzmocnienia różnią się {value} razy</translation>
    </message>
    <message>
        <location filename="../plugin/seams/words.py" line="127"/>
        <source>the mosaic is blurred</source>
        <translation>ortofotomapa jest rozmyta</translation>
    </message>
    <message>
        <location filename="../plugin/seams/words.py" line="138"/>
        <source>images are feathered</source>
        <translation>obrazy są wtopione</translation>
    </message>
    <message>
        <location filename="../plugin/seams/words.py" line="159"/>
        <source>the histogram is narrowed</source>
        <translation>histogram jest zawężony</translation>
    </message>
    <message>
        <location filename="../plugin/seams/words.py" line="166"/>
        <source>grey values are bent by a gamma</source>
        <translation>jasności są zmienione potęgowo (gamma)</translation>
    </message>
    <message>
        <location filename="../plugin/seams/words.py" line="175"/>
        <source>highlights or shadows are clipped</source>
        <translation>światła lub cienie są obcięte</translation>
    </message>
    <message>
        <location filename="../plugin/seams/words.py" line="186"/>
        <source>the colours are shifted</source>
        <translation>barwy są przesunięte</translation>
    </message>
    <message>
        <location filename="../plugin/seams/report/flagged_windows.py" line="228"/>
        <source>hard-cut composite (dashed)</source>
        <translation>kompozycja z ostrym cięciem (przerywana)</translation>
    </message>
    <message>
        <location filename="../plugin/seams/report/flagged_windows.py" line="227"/>
        <source>{name} (mosaic, bold)</source>
        <translation>{name} (ortofotomapa, gruba)</translation>
    </message>
    <message>
        <source>Ground resolved distance: {name}</source>
        <translation>Terenowa zdolność rozdzielcza: {name}</translation>
    </message>
    <message>
        <source>direction</source>
        <translation>kierunek</translation>
    </message>
    <message>
        <location filename="../plugin/noise/report.py" line="139"/>
        <source>band</source>
        <translation>kanał</translation>
    </message>
    <message>
        <source>distance, cm</source>
        <translation>GRD, cm</translation>
    </message>
    <message>
        <source>The target</source>
        <translation>Test</translation>
    </message>
    <message>
        <source>Profiles</source>
        <translation>Profile</translation>
    </message>
    <message>
        <source>Measurements</source>
        <translation>Pomiary</translation>
    </message>
    <message>
        <source>bars</source>
        <translation>paski</translation>
    </message>
    <message>
        <source>amplitude, DN</source>
        <translation>amplituda, DN</translation>
    </message>
    <message>
        <source>full amplitude, DN</source>
        <translation>pełna amplituda, DN</translation>
    </message>
    <message>
        <source>modulation</source>
        <translation>modulacja</translation>
    </message>
    <message>
        <source>shift, px</source>
        <translation>przesunięcie, px</translation>
    </message>
    <message>
        <source>Reasons</source>
        <translation>Powody</translation>
    </message>
    <message>
        <location filename="../plugin/resolution/report.py" line="105"/>
        <source>No group is resolved in every band.</source>
        <translation>Żadna grupa nie jest rozróżniona w każdym kanale.</translation>
    </message>
    <message>
        <source>Flagged windows</source>
        <translation>Oznaczone okna</translation>
    </message>
    <message>
        <source>None: no window has a significant loss, and in none did the observer see one.</source>
        <translation>Brak: w żadnym oknie nie ma istotnej straty i w żadnym obserwator jej nie zauważył.</translation>
    </message>
    <message>
        <location filename="../plugin/noise/report.py" line="61"/>
        <source>windows</source>
        <translation>okna</translation>
    </message>
    <message>
        <source>Causes</source>
        <translation>Przyczyny</translation>
    </message>
    <message>
        <source>of them flagged</source>
        <translation>w tym oznaczone</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/paper/decision_map.py" line="138"/>
        <source>N</source>
        <translation>N</translation>
    </message>
    <message>
        <location filename="../plugin/toolkit/packages.py" line="22"/>
        <source>Seam Inspector needs the Python package(s) {packages}.</source>
        <translation>Seam Inspector wymaga pakietów Pythona: {packages}.</translation>
    </message>
    <message>
        <location filename="../plugin/toolkit/packages.py" line="31"/>
        <source>The Python package {package} can&apos;t be loaded ({error}).</source>
        <translation>Nie można wczytać pakietu Pythona {package} ({error}).</translation>
    </message>
    <message>
        <location filename="../plugin/toolkit/packages.py" line="39"/>
        <source>Run &apos;{command}&apos; in a terminal, then restart QGIS.</source>
        <translation>Uruchom „{command}” w terminalu, a potem uruchom ponownie QGIS.</translation>
    </message>
    <message>
        <location filename="../plugin/radiometry/report.py" line="174"/>
        <source>value (DN)</source>
        <translation>wartość (DN)</translation>
    </message>
    <message>
        <location filename="../plugin/radiometry/report.py" line="175"/>
        <source>pixels (%)</source>
        <translation>piksele (%)</translation>
    </message>
    <message>
        <location filename="../plugin/radiometry/report.py" line="201"/>
        <source>largest step at a seam (% of the largest value)</source>
        <translation>największy skok na linii mozaikowania (% największej wartości)</translation>
    </message>
    <message>
        <location filename="../plugin/radiometry/report.py" line="202"/>
        <source>contrast beside the seams (% of the range)</source>
        <translation>kontrast przy liniach mozaikowania (% zakresu)</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/dock.py" line="220"/>
        <source>Write a report of the inspected windows, one HTML page that opens anywhere</source>
        <translation>Zapisz raport ze skontrolowanych okien: jedną stronę HTML, którą można otworzyć wszędzie</translation>
    </message>
    <message>
        <location filename="../plugin/imagery/messages.py" line="67"/>
        <source>{what}: {why}</source>
        <translation>{what}: {why}</translation>
    </message>
    <message>
        <location filename="../plugin/photos/measure/messages.py" line="125"/>
        <source>affine</source>
        <translation>transformacji afinicznej</translation>
    </message>
    <message>
        <location filename="../plugin/photos/measure/messages.py" line="125"/>
        <source>similarity</source>
        <translation>transformacji przez podobieństwo</translation>
    </message>
    <message>
        <location filename="../plugin/photos/measure/messages.py" line="125"/>
        <source>projective</source>
        <translation>transformacji rzutowej</translation>
    </message>
    <message>
        <location filename="../plugin/photos/measure/messages.py" line="126"/>
        <source>Measured</source>
        <translation>Zmierzony</translation>
    </message>
    <message>
        <location filename="../plugin/photos/measure/messages.py" line="126"/>
        <source>Given</source>
        <translation>Podany</translation>
    </message>
    <message>
        <location filename="../plugin/photos/measure/messages.py" line="126"/>
        <source>Failed</source>
        <translation>Odrzucony</translation>
    </message>
    <message>
        <location filename="../plugin/photos/measure/messages.py" line="127"/>
        <source>positions</source>
        <translation>podanych położeń</translation>
    </message>
    <message>
        <location filename="../plugin/photos/measure/messages.py" line="127"/>
        <source>dots</source>
        <translation>kropek</translation>
    </message>
    <message>
        <location filename="../plugin/photos/measure/messages.py" line="127"/>
        <source>data strip</source>
        <translation>paska danych</translation>
    </message>
    <message>
        <location filename="../plugin/photos/measure/messages.py" line="127"/>
        <source>residuals</source>
        <translation>odchyłek</translation>
    </message>
    <message>
        <location filename="../plugin/photos/measure/messages.py" line="128"/>
        <source>marks</source>
        <translation>układu znaczków</translation>
    </message>
    <message>
        <location filename="../plugin/photos/measure/messages.py" line="128"/>
        <source>assumed</source>
        <translation>założenia</translation>
    </message>
    <message>
        <location filename="../plugin/seams/report/flagged_windows.py" line="56"/>
        <source>by the paper&apos;s rule: {verdict}</source>
        <translation>według reguły z artykułu: {verdict}</translation>
    </message>
    <message>
        <location filename="../plugin/seams/report/flagged_windows.py" line="183"/>
        <source>kept along the seam</source>
        <translation>zachowane wzdłuż linii mozaikowania</translation>
    </message>
    <message>
        <location filename="../plugin/seams/report/flagged_windows.py" line="230"/>
        <source>significant by the paper&apos;s rule below</source>
        <translation>poniżej istotna strata według reguły z artykułu</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/windows/window_columns.py" line="109"/>
        <source>The verdict, by the seam or by the inputs. Sorted by this column, the worst comes first.</source>
        <translation>Ocena: według linii mozaikowania albo tego, co ustawiono w danych wejściowych. Po posortowaniu najgorsze są na początku.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/inputs/inputs_panel.py" line="286"/>
        <source>By the sources or their composite, a loss is significant when the mosaic keeps at most this share of their detail at level 1</source>
        <translation>Według ortoobrazów źródłowych lub ich kompozycji strata jest istotna, gdy ortofotomapa zachowuje na poziomie 1 najwyżej taką część ich detali</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/inputs/inputs_panel.py" line="261"/>
        <source>the seam</source>
        <translation>linii mozaikowania</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/inputs/inputs_panel.py" line="261"/>
        <source>the composite</source>
        <translation>kompozycji</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/inputs/inputs_panel.py" line="261"/>
        <source>the sources (paper)</source>
        <translation>ortoobrazów (artykuł)</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/inputs/inputs_panel.py" line="280"/>
        <source>What decides the verdict: what is kept along the seam; the whole window against the hard cut of the sources; or each source&apos;s whole clip, as in Pyka&apos;s papers</source>
        <translation>Według czego zapada ocena: tego, co zachowano wzdłuż linii mozaikowania; całego okna względem ostrego cięcia ortoobrazów; albo całego wycinka każdego ortoobrazu, jak w pracach Pyki</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/inputs/inputs_panel.py" line="279"/>
        <source>Verdict &amp;by</source>
        <translation>Ocena &amp;według</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/inputs/inputs_panel.py" line="282"/>
        <source>Least &amp;kept</source>
        <translation>&amp;Najmniej zachowane</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/inputs/inputs_panel.py" line="285"/>
        <source>Largest &amp;ratio</source>
        <translation>Największy &amp;stosunek</translation>
    </message>
    <message>
        <location filename="../plugin/seams/words.py" line="200"/>
        <source>missing source</source>
        <translation>brak ortoobrazu</translation>
    </message>
    <message>
        <location filename="../plugin/seams/words.py" line="211"/>
        <source>resampled</source>
        <translation>przepróbkowanie</translation>
    </message>
    <message>
        <location filename="../plugin/seams/words.py" line="212"/>
        <source>The mosaic&apos;s pixels lie between those of its sources, so they were interpolated from them.</source>
        <translation>Piksele ortofotomapy leżą między pikselami ortoobrazów źródłowych, więc powstały z nich przez interpolację.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/words.py" line="213"/>
        <source>the mosaic was resampled</source>
        <translation>ortofotomapa została przepróbkowana</translation>
    </message>
    <message>
        <location filename="../plugin/seams/words.py" line="214"/>
        <source>the mosaic was resampled, {value} px off the sources&apos; pixels</source>
        <translation>ortofotomapa została przepróbkowana z przesunięciem o {value} px względem pikseli ortoobrazów</translation>
    </message>
    <message>
        <location filename="../plugin/seams/words.py" line="222"/>
        <source>sharpened</source>
        <translation>wyostrzenie</translation>
    </message>
    <message>
        <location filename="../plugin/seams/words.py" line="223"/>
        <source>The whole mosaic was sharpened, beyond what its sources show.</source>
        <translation>Cała ortofotomapa została wyostrzona ponad to, co pokazują ortoobrazy źródłowe.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/words.py" line="224"/>
        <source>the mosaic was sharpened</source>
        <translation>ortofotomapa została wyostrzona</translation>
    </message>
    <message>
        <location filename="../plugin/seams/words.py" line="225"/>
        <source>the mosaic was sharpened to {value} % of the sources&apos; contrast</source>
        <translation>ortofotomapa została wyostrzona do {value} % kontrastu ortoobrazów źródłowych</translation>
    </message>
    <message>
        <location filename="../plugin/seams/words.py" line="230"/>
        <source>compressed</source>
        <translation>kompresja</translation>
    </message>
    <message>
        <location filename="../plugin/seams/words.py" line="231"/>
        <source>Lossy compression, block by block, changed the fine detail.</source>
        <translation>Kompresja stratna, blok po bloku, zmieniła drobne detale.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/words.py" line="232"/>
        <source>the mosaic was compressed with loss</source>
        <translation>ortofotomapa została poddana kompresji stratnej</translation>
    </message>
    <message>
        <location filename="../plugin/seams/words.py" line="233"/>
        <source>the mosaic was compressed with loss, which changed fine detail by {value} DN</source>
        <translation>ortofotomapa została poddana kompresji stratnej, która zmieniła drobne detale o {value} DN</translation>
    </message>
    <message>
        <location filename="../plugin/seams/words.py" line="241"/>
        <source>noise added</source>
        <translation>dodany szum</translation>
    </message>
    <message>
        <location filename="../plugin/seams/words.py" line="242"/>
        <source>The mosaic has noise that its sources do not have.</source>
        <translation>Ortofotomapa ma szum, którego nie mają ortoobrazy źródłowe.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/words.py" line="243"/>
        <source>noise was added</source>
        <translation>dodano szum</translation>
    </message>
    <message>
        <location filename="../plugin/seams/words.py" line="244"/>
        <source>noise of {value} DN was added</source>
        <translation>dodano szum {value} DN</translation>
    </message>
    <message>
        <location filename="../plugin/seams/words.py" line="249"/>
        <source>dodging</source>
        <translation>wyrównanie jasności</translation>
    </message>
    <message>
        <location filename="../plugin/seams/words.py" line="251"/>
        <source>brightness was evened out from place to place</source>
        <translation>jasność wyrównano zmiennie z miejsca na miejsce</translation>
    </message>
    <message>
        <location filename="../plugin/seams/words.py" line="257"/>
        <source>balanced</source>
        <translation>wyrównanie tonalne</translation>
    </message>
    <message>
        <location filename="../plugin/seams/words.py" line="258"/>
        <source>The sources&apos; tones were matched, each by its gain and bias; nothing is lost.</source>
        <translation>Ortoobrazy sprowadzono do wspólnej tonacji, każdy własnym wzmocnieniem i przesunięciem; nic przy tym nie utracono.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/words.py" line="259"/>
        <source>the sources&apos; tones were balanced</source>
        <translation>tonacje ortoobrazów wyrównano</translation>
    </message>
    <message>
        <location filename="../plugin/seams/words.py" line="260"/>
        <source>the sources&apos; tones were balanced, gains a factor of {value} apart</source>
        <translation>tonacje ortoobrazów wyrównano wzmocnieniami, które różnią się {value} razy</translation>
    </message>
    <message>
        <location filename="../plugin/seams/words.py" line="266"/>
        <source>no step of production took detail away, so the sources differ in content</source>
        <translation>żaden etap produkcji nie odebrał detali, więc ortoobrazy różnią się treścią</translation>
    </message>
    <message>
        <location filename="../plugin/seams/measure/messages.py" line="103"/>
        <source>{name} covers {share:.0f} % of the window and is used there.</source>
        <translation>{name} pokrywa {share:.0f} % okna i tam bierze udział.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/measure/messages.py" line="116"/>
        <source>All sources have another pixel size or system than the mosaic and were resampled, which changes detail; so the verdict is uncertain.</source>
        <translation>Wszystkie ortoobrazy mają inną wielkość piksela lub inny układ niż ortofotomapa i zostały przepróbkowane, co zmienia detale; ocena jest przez to niepewna.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/measure/messages.py" line="180"/>
        <source>{count} windows are flagged and the report shows curves and clips of the {most} with the greatest losses; the others are in the table. Report a part of the windows to see them.</source>
        <translation>Oznaczonych okien jest {count}, a raport pokazuje krzywe i wycinki {most} z największymi stratami; pozostałe są w tabeli. Aby je zobaczyć, zrób raport z części okien.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/algorithms/inspectwindows.py" line="59"/>
        <source>seam: what is kept along the seam, against the hard-cut composite of the sources and the ground around. composite: the whole window against that composite. sources: the whole clip of each source, as in the paper; that verdict is always in the field &apos;paper_verdict&apos;, too.</source>
        <translation>seam: to, co zachowano wzdłuż linii mozaikowania, względem kompozycji ortoobrazów źródłowych z ostrym cięciem i terenu wokół. composite: całe okno względem tej kompozycji. sources: cały wycinek każdego ortoobrazu źródłowego, jak w artykule; ta ocena jest zawsze także w polu „paper_verdict”.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/algorithms/inspectwindows.py" line="69"/>
        <source>Least share kept along the seam</source>
        <translation>Najmniejsza część zachowana wzdłuż linii mozaikowania</translation>
    </message>
    <message>
        <location filename="../plugin/seams/algorithms/inspectwindows.py" line="78"/>
        <source>By the paper&apos;s rule a window is significant when its ratio at level 1 is this or less.</source>
        <translation>Według reguły z artykułu okno otrzymuje ocenę „istotna strata” (significant), gdy jego stosunek wariancji na poziomie 1 nie przekracza tej wartości.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/algorithms/inspectwindows.py" line="96"/>
        <source>Seam profiles</source>
        <translation>Profile linii mozaikowania</translation>
    </message>
    <message>
        <location filename="../plugin/seams/algorithms/inspectwindows.py" line="97"/>
        <source>What is kept of each level&apos;s detail by distance from the seam, with its 95 % interval.</source>
        <translation>Co zachowano z detali każdego poziomu w zależności od odległości od linii mozaikowania, z przedziałem ufności 95 %.</translation>
    </message>
    <message>
        <source>main cause in</source>
        <translation>główna przyczyna w</translation>
    </message>
    <message>
        <source>contributed in</source>
        <translation>udział w</translation>
    </message>
    <message>
        <source>share, level</source>
        <translation>część, poziom</translation>
    </message>
    <message>
        <source>median</source>
        <translation>mediana</translation>
    </message>
    <message>
        <source>kept 1</source>
        <translation>zachow. 1</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/dock.py" line="201"/>
        <source>Scan</source>
        <translation>Zbadaj</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/dock.py" line="201"/>
        <source>Scan the whole mosaic: where it lost detail, and what each piece of its seams kept</source>
        <translation>Zbadaj całą ortofotomapę: gdzie straciła detale i ile zachował każdy odcinek jej linii mozaikowania</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/dock.py" line="206"/>
        <source>Judge the worst places</source>
        <translation>Oceń najgorsze miejsca</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/dock.py" line="206"/>
        <source>Judge the worst places of the last scan, worst first</source>
        <translation>Oceń najgorsze miejsca z ostatniego badania, zaczynając od najgorszego</translation>
    </message>
    <message>
        <location filename="../plugin/seams/algorithms/scanmosaic.py" line="78"/>
        <source>Picture of losses</source>
        <translation>Obraz strat</translation>
    </message>
    <message>
        <location filename="../plugin/seams/algorithms/scanmosaic.py" line="86"/>
        <source>Source cells</source>
        <translation>Komórki ortofotomapy</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/acceptmosaic.py" line="50"/>
        <source>Seams</source>
        <translation>Odcinki linii mozaikowania</translation>
    </message>
    <message>
        <location filename="../plugin/seams/algorithms/scanmosaic.py" line="89"/>
        <source>Worst places</source>
        <translation>Najgorsze miejsca</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/mosaic_scans.py" line="88"/>
        <source>Scan of {mosaic}</source>
        <translation>Badanie: {mosaic}</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/mosaic_scans.py" line="90"/>
        <source>Scan the mosaic</source>
        <translation>Zbadaj ortofotomapę</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/mosaic_scans.py" line="113"/>
        <source>Scan: {percent} %</source>
        <translation>Badanie: {percent} %</translation>
    </message>
    <message>
        <location filename="../plugin/seams/jobs.py" line="76"/>
        <source>less than a minute left</source>
        <translation>została niecała minuta</translation>
    </message>
    <message>
        <location filename="../plugin/seams/jobs.py" line="78"/>
        <source>about {count} min left</source>
        <translation>zostało ok. {count} min</translation>
    </message>
    <message>
        <location filename="../plugin/seams/jobs.py" line="79"/>
        <source>about {count} h left</source>
        <translation>zostało ok. {count} godz.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/tables/scan_layers.py" line="78"/>
        <source>Scanned: no seam was found.</source>
        <translation>Zbadano: nie znaleziono żadnej linii mozaikowania.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/inputs/inputs_panel.py" line="258"/>
        <source>Spacing of placed windows, wavelet, levels, the limit of a significant loss and what it is compared with, seam cells, how a whole mosaic is scanned</source>
        <translation>Odstęp rozmieszczanych okien, falka, liczba poziomów, granica istotnej straty i jej odniesienie, komórki ortofotomapy, sposób badania całej ortofotomapy</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/paper/inspection_record.py" line="81"/>
        <source>along the seams</source>
        <translation>wzdłuż linii mozaikowania</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/paper/inspection_record.py" line="81"/>
        <source>every pixel</source>
        <translation>każdy piksel</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/inputs/inputs_panel.py" line="292"/>
        <source>What a scan of the whole mosaic measures: everything along the seams and samples elsewhere, in about the time that reading takes, or everything everywhere</source>
        <translation>Co mierzy badanie całej ortofotomapy: wszystko wzdłuż linii mozaikowania, a poza nimi próbki, mniej więcej w czasie samego odczytu, albo wszystko wszędzie</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/inputs/inputs_panel.py" line="295"/>
        <source>Metres of seam that a scan measures and judges as one</source>
        <translation>Długość odcinka linii mozaikowania w metrach, który badanie mierzy i ocenia jako całość</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/inputs/inputs_panel.py" line="270"/>
        <source>whole mosaic</source>
        <translation>cała ortofotomapa</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/inputs/inputs_panel.py" line="296"/>
        <source>Metres that a scan reads on either side of the seamlines</source>
        <translation>Ile metrów po każdej stronie linii mozaikowania odczytuje badanie</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/inputs/inputs_panel.py" line="291"/>
        <source>Sca&amp;n</source>
        <translation>B&amp;adanie</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/inputs/inputs_panel.py" line="294"/>
        <source>Se&amp;am pieces</source>
        <translation>O&amp;dcinki linii</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/inputs/inputs_panel.py" line="296"/>
        <source>C&amp;orridor</source>
        <translation>Kory&amp;tarz</translation>
    </message>
    <message>
        <location filename="../plugin/seams/measure/messages.py" line="281"/>
        <source>{path} can&apos;t be written ({error}). What was measured is saved (blocks done: {done}); make room on the disk and start it again with the same output to go on.</source>
        <translation>Nie można zapisać pliku {path} ({error}). To, co zmierzono, jest zachowane (gotowe bloki: {done}); zwolnij miejsce na dysku i zacznij ponownie z tym samym plikiem wyniku, aby kontynuować.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/measure/messages.py" line="285"/>
        <source>{path} can&apos;t be read any more ({error}); start it again with the same output, and what is damaged is measured again.</source>
        <translation>Nie można już odczytać pliku {path} ({error}); zacznij ponownie z tym samym plikiem wyniku, a to, co uszkodzone, zostanie zmierzone jeszcze raz.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/measure/messages.py" line="233"/>
        <source>The seamline layer has no field &apos;{field}&apos;; choose one of its fields: {known}.</source>
        <translation>Warstwa linii mozaikowania nie ma pola „{field}”; wybierz jedno z jej pól: {known}.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/measure/messages.py" line="236"/>
        <source>None of the {count} features of the seamline layer lies on the mosaic; check the reference systems of both.</source>
        <translation>Żaden z obiektów warstwy linii mozaikowania (liczba: {count}) nie leży na ortofotomapie; sprawdź układy współrzędnych warstwy i ortofotomapy.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/measure/messages.py" line="239"/>
        <source>The seamline layer names no orthoimages beside its seams, in a field &apos;source&apos; for instance; where orthoimages are given, the pixels decide which of them the mosaic shows.</source>
        <translation>Warstwa linii mozaikowania nie podaje nazw ortoobrazów po obu stronach linii, na przykład w polu „source”; gdy podano ortoobrazy, o tym, z którego z nich pochodzi dana część, mówi sama ortofotomapa.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/measure/messages.py" line="252"/>
        <source>Polygons of the seamline layer whose outline crosses itself, repaired: {count}.</source>
        <translation>Naprawione poligony warstwy linii mozaikowania, których obrys przecinał sam siebie: {count}.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/measure/messages.py" line="255"/>
        <source>Orthoimages that the seamline layer names and that are not given: {count} (such as {names}).</source>
        <translation>Ortoobrazy wymienione w warstwie linii mozaikowania, których nie podano: {count} (przede wszystkim {names}).</translation>
    </message>
    <message>
        <location filename="../plugin/seams/measure/messages.py" line="267"/>
        <source>Features of the seamline layer that can&apos;t be brought into the mosaic&apos;s reference system, left out: {count}.</source>
        <translation>Pominięte obiekty warstwy linii mozaikowania, których nie można przeliczyć do układu współrzędnych ortofotomapy: {count}.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/measure/messages.py" line="340"/>
        <source>Too little of this seam can be measured, or of the ground on one side of it; give the orthoimages.</source>
        <translation>Za małą część tej linii mozaikowania albo terenu po jednej z jej stron można zmierzyć; podaj ortoobrazy źródłowe.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/measure/messages.py" line="347"/>
        <source>Without orthoimages the ground here is not enough: between {low:.0f} and {high:.0f} % of the finest detail is kept. Give the orthoimages to have a verdict.</source>
        <translation>Bez ortoobrazów źródłowych teren mówi tu za mało: zachowane jest od {low:.0f} do {high:.0f} % najdrobniejszych detali. Aby otrzymać ocenę, podaj ortoobrazy źródłowe.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/measure/messages.py" line="199"/>
        <source>Neither orthoimages nor seamlines are given; add the orthoimages, or the seamlines to scan the mosaic alone.</source>
        <translation>Nie podano ani ortoobrazów źródłowych, ani linii mozaikowania; dodaj ortoobrazy albo linie mozaikowania, aby zbadać samą ortofotomapę.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/measure/messages.py" line="351"/>
        <source>All seams together keep {kept:.0f} % of the finest detail ({low:.0f} to {high:.0f} %), by the ground beside them.</source>
        <translation>Wzdłuż wszystkich linii mozaikowania razem zachowane jest {kept:.0f} % najdrobniejszych detali (od {low:.0f} do {high:.0f} %) w odniesieniu do terenu obok nich.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/measure/messages.py" line="359"/>
        <source>Without orthoimages no piece of seam can be judged on this mosaic, however long; add its orthoimages.</source>
        <translation>Bez ortoobrazów źródłowych nie można na tej ortofotomapie ocenić żadnego odcinka linii mozaikowania, nawet najdłuższego; dodaj jej ortoobrazy.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/measure/messages.py" line="202"/>
        <source>The mosaic has {width} x {height} pixels and a scan needs {fewest} at least; inspect it in windows instead.</source>
        <translation>Ortofotomapa ma {width} × {height} pikseli, a bok badanej ortofotomapy musi mieć ich co najmniej {fewest}; skontroluj ją w oknach.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/measure/messages.py" line="205"/>
        <source>No orthoimage lies on the mosaic, of {count}; check the reference systems, or give those that it was made from.</source>
        <translation>Żaden z podanych ortoobrazów (liczba: {count}) nie leży na ortofotomapie; sprawdź układy współrzędnych albo podaj ortoobrazy, z których powstała.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/measure/messages.py" line="290"/>
        <source>The layer {name} can&apos;t be written. What was measured is saved; make room on the disk, or choose another file for the layer, and start the scan again with the same picture of losses to go on.</source>
        <translation>Nie można zapisać warstwy {name}. To, co zmierzono, jest zachowane; zwolnij miejsce na dysku albo wybierz inny plik warstwy i uruchom badanie ponownie z tym samym obrazem strat, aby je kontynuować.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/measure/messages.py" line="308"/>
        <source>This piece is {length:.1f} m long and {needed:.1f} m are needed to measure it; take longer pieces, or judge it by eye.</source>
        <translation>Ten odcinek ma {length:.1f} m długości, a do pomiaru potrzeba {needed:.1f} m; ustaw dłuższe odcinki albo oceń go okiem.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/algorithms/scanmosaic.py" line="40"/>
        <source>Scan a whole mosaic</source>
        <translation>Zbadaj całą ortofotomapę</translation>
    </message>
    <message>
        <location filename="../plugin/seams/algorithms/scanmosaic.py" line="51"/>
        <source>Lines, or polygons that are each filled from one orthoimage. Without them seams are found from the pixels. Needed where there are no orthoimages.</source>
        <translation>Linie albo poligony, z których każdy jest wypełniony jednym ortoobrazem. Bez nich linie mozaikowania są znajdowane na podstawie pikseli. Wymagane, gdy nie ma ortoobrazów źródłowych.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/algorithms/scanmosaic.py" line="54"/>
        <source>Field with the orthoimage&apos;s name</source>
        <translation>Pole z nazwą ortoobrazu</translation>
    </message>
    <message>
        <location filename="../plugin/seams/algorithms/scanmosaic.py" line="55"/>
        <source>For seamlines that are polygons. Empty: the first of the fields that producers use, such as source, CLICHE, image or imageSourceReference.</source>
        <translation>Dla linii mozaikowania podanych jako poligony. Puste: pierwsze z pól używanych przez producentów, takich jak source, CLICHE, image lub imageSourceReference.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/algorithms/scanmosaic.py" line="58"/>
        <source>Corridor (metres)</source>
        <translation>Korytarz (metry)</translation>
    </message>
    <message>
        <location filename="../plugin/seams/algorithms/scanmosaic.py" line="59"/>
        <source>Width that is read on either side of the seamlines; 0: the whole mosaic.</source>
        <translation>Szerokość pasa odczytywanego po każdej stronie linii mozaikowania; 0: cała ortofotomapa.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/algorithms/scanmosaic.py" line="61"/>
        <source>Density</source>
        <translation>Gęstość pomiaru</translation>
    </message>
    <message>
        <location filename="../plugin/seams/algorithms/scanmosaic.py" line="62"/>
        <source>seams: every pixel along the seams, samples elsewhere; takes about as long as reading the files. full: every pixel everywhere.</source>
        <translation>seams: każdy piksel wzdłuż linii mozaikowania, a poza nimi próbki; trwa mniej więcej tyle, co odczyt plików. full: wszędzie każdy piksel.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/algorithms/scanmosaic.py" line="66"/>
        <source>Length of a piece of seam (metres)</source>
        <translation>Długość odcinka linii mozaikowania (metry)</translation>
    </message>
    <message>
        <location filename="../plugin/seams/algorithms/scanmosaic.py" line="67"/>
        <source>Seams are measured and judged in pieces of about this length.</source>
        <translation>Linie mozaikowania są mierzone i oceniane w odcinkach mniej więcej tej długości.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/algorithms/scanmosaic.py" line="69"/>
        <source>Cell of the picture (pixels)</source>
        <translation>Komórka obrazu strat (piksele)</translation>
    </message>
    <message>
        <location filename="../plugin/seams/algorithms/scanmosaic.py" line="70"/>
        <source>Side of a pixel of the picture of losses, in pixels of the mosaic: 16, 32, 64, 128 or 256.</source>
        <translation>Bok piksela obrazu strat w pikselach ortofotomapy: 16, 32, 64, 128 lub 256.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/algorithms/scanmosaic.py" line="72"/>
        <source>Windows of the worst places</source>
        <translation>Liczba okien najgorszych miejsc</translation>
    </message>
    <message>
        <location filename="../plugin/seams/algorithms/scanmosaic.py" line="73"/>
        <source>How many windows are placed where least was kept.</source>
        <translation>Ile okien jest umieszczanych tam, gdzie zachowano najmniej.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/algorithms/scanmosaic.py" line="80"/>
        <source>A GeoTIFF with the bands kept_1, contrast_1, added_1, source and mixture. What was not measured is nodata.</source>
        <translation>Plik GeoTIFF z kanałami kept_1, contrast_1, added_1, source i mixture. To, czego nie zmierzono, ma wartość braku danych (nodata).</translation>
    </message>
    <message>
        <location filename="../plugin/seams/algorithms/scanmosaic.py" line="87"/>
        <source>Polygons that say in the field &apos;source&apos; which orthoimage each part of the mosaic came from.</source>
        <translation>Poligony, które w polu „source” podają, z którego ortoobrazu pochodzi każda część ortofotomapy.</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/acceptmosaic.py" line="78"/>
        <source>Length of all seams (metres)</source>
        <translation>Długość wszystkich linii mozaikowania (metry)</translation>
    </message>
    <message>
        <location filename="../plugin/seams/algorithms/scanmosaic.py" line="95"/>
        <source>Least share kept by a piece</source>
        <translation>Najmniejsza część zachowana przez odcinek</translation>
    </message>
    <message>
        <location filename="../plugin/seams/measure/messages.py" line="185"/>
        <source>{name} is {value:g}; give {least} or more.</source>
        <translation>{name} wynosi {value:g}; podaj liczbę nie mniejszą niż {least}.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/measure/messages.py" line="195"/>
        <source>Pieces of seam are made {needed:.1f} m long: at this pixel size shorter ones can&apos;t be measured.</source>
        <translation>Odcinki linii mozaikowania mają {needed:.1f} m: przy tej wielkości piksela krótszych nie można zmierzyć.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/measure/messages.py" line="192"/>
        <source>The corridor applies only with seamlines; without them all of the mosaic is read.</source>
        <translation>Korytarz liczy się tylko z liniami mozaikowania; bez nich czytana jest cała ortofotomapa.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/measure/messages.py" line="186"/>
        <source>The picture of losses is a GeoTIFF; give {path} the ending .tif.</source>
        <translation>Obraz strat jest plikiem GeoTIFF; podaj {path} z rozszerzeniem .tif.</translation>
    </message>
    <message>
        <location filename="../plugin/imagery/messages.py" line="101"/>
        <source>another QGIS has it open</source>
        <translation>plik jest otwarty w innym QGIS</translation>
    </message>
    <message>
        <location filename="../plugin/seams/words.py" line="319"/>
        <source>50 % kept, or less</source>
        <translation>50 % lub mniej</translation>
    </message>
    <message>
        <location filename="../plugin/seams/words.py" line="320"/>
        <source>50 to 60 %</source>
        <translation>od 50 do 60 %</translation>
    </message>
    <message>
        <location filename="../plugin/seams/words.py" line="321"/>
        <source>60 to 70 %</source>
        <translation>od 60 do 70 %</translation>
    </message>
    <message>
        <location filename="../plugin/seams/words.py" line="322"/>
        <source>70 to 80 %</source>
        <translation>od 70 do 80 %</translation>
    </message>
    <message>
        <location filename="../plugin/seams/words.py" line="323"/>
        <source>80 to 90 %</source>
        <translation>od 80 do 90 %</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/windows/windows_panel.py" line="66"/>
        <source>not sure</source>
        <translation>niepewna</translation>
    </message>
    <message>
        <location filename="../plugin/seams/report/flagged_windows.py" line="71"/>
        <source>found: {cause}</source>
        <translation>znaleziono: {cause}</translation>
    </message>
    <message>
        <location filename="../plugin/seams/report/flagged_windows.py" line="172"/>
        <source>Found: {cause}.</source>
        <translation>Znaleziono: {cause}.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/images/images_panel.py" line="194"/>
        <source>{name} (its own stretch)</source>
        <translation>{name} (własne rozciągnięcie)</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/images/images_panel.py" line="192"/>
        <source>{name}: reading ...</source>
        <translation>{name}: wczytywanie...</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/judge_bar.py" line="126"/>
        <source>A remark on the window (R); Enter saves it, Esc discards the change.</source>
        <translation>Uwaga o oknie (R); Enter ją zapisuje, a Esc zostawia taką, jaka była.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/windows/window_columns.py" line="142"/>
        <source>remark</source>
        <translation>uwaga</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/judge_bar.py" line="195"/>
        <source>Remark:</source>
        <translation>Uwaga:</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/judge_bar.py" line="226"/>
        <source>Verdicts go to the field &apos;observer&apos;.</source>
        <translation>Opinia trafia do pola „observer”.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/judge_bar.py" line="227"/>
        <source>Verdicts go to the field &apos;observer_2&apos;, beside the first operator&apos;s.</source>
        <translation>Opinia trafia do pola „observer_2”, obok opinii pierwszego operatora.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/judge_bar.py" line="223"/>
        <source>Hides the tool&apos;s results and the other operator&apos;s verdicts in the table, in words, charts and on the map.</source>
        <translation>Ukrywa to, co znalazło narzędzie, i opinię drugiego operatora: w tabeli, w opisach, na wykresach i na mapie.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/judge_bar.py" line="227"/>
        <source>2nd</source>
        <translation>Op. 2</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/judge_bar.py" line="226"/>
        <source>1st</source>
        <translation>Op. 1</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/judge_bar.py" line="229"/>
        <source>{operator}, blind</source>
        <translation>{operator}, w ciemno</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/judge_bar.py" line="73"/>
        <source>Not sure (U)</source>
        <translation>Niepewna (U)</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/judge_bar.py" line="73"/>
        <source>You can&apos;t tell. The window counts as not judged in all results.</source>
        <translation>Nie da się powiedzieć. We wszystkich wynikach okno liczy się jako okno bez opinii.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/judge_bar.py" line="77"/>
        <source>Goes on without judging: to the next compared window that is not judged yet, or the next one (N).</source>
        <translation>Idzie dalej bez wydania opinii: do następnego porównanego okna bez opinii, a jeśli go nie ma, do następnego (N).</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/judge_bar.py" line="152"/>
        <source>Window {numbers}. Results are hidden.</source>
        <translation>Okno {numbers}. Wynik jest ukryty.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/judge_bar.py" line="254"/>
        <source>Then goes to the next window. Click again to undo it.</source>
        <translation>Potem pojawia się następne okno. Ponowne kliknięcie wycofuje opinię.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/judging.py" line="232"/>
        <source>Write this into {count} windows?</source>
        <translation>Wpisać to do {count} {count:okna|okien|okien}?</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/judging.py" line="240"/>
        <source>Judge {count} windows as {word}?</source>
        <translation>Wpisać opinię „{word}” do {count} {count:okna|okien|okien}?</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/judging.py" line="242"/>
        <source>Take back the verdicts on {count} windows?</source>
        <translation>Wycofać opinie o {count} {count:oknie|oknach|oknach}?</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/map/hard_cut.py" line="75"/>
        <source>Cut the composite</source>
        <translation>Wytnij kompozycję</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/images/images_panel.py" line="176"/>
        <source>hard cut of the sources</source>
        <translation>ostre cięcie ortoobrazów</translation>
    </message>
    <message>
        <location filename="../plugin/seams/charts/profile_painter.py" line="233"/>
        <source>limit {percent} %</source>
        <translation>granica {percent} %</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/paper/acceptance_report.py" line="363"/>
        <source>distance from the seam (m)</source>
        <translation>odległość od linii mozaikowania (m)</translation>
    </message>
    <message>
        <location filename="../plugin/seams/charts/profile_painter.py" line="243"/>
        <source>from the seam (m)</source>
        <translation>od linii (m)</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/charts/curves_tab.py" line="152"/>
        <source>How much of the finest detail is kept, by the distance from the seam, relative to the ground around</source>
        <translation>Ile najdrobniejszych detali zachowano w zależności od odległości od linii mozaikowania, w odniesieniu do terenu wokół</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/charts/curves_tab.py" line="190"/>
        <source>Select one window to see its seam profile.</source>
        <translation>Zaznacz jedno okno, aby zobaczyć profil jego linii mozaikowania.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/charts/curves_tab.py" line="218"/>
        <source>Live: </source>
        <translation>Na żywo: </translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/dock.py" line="349"/>
        <source>There is no window yet: draw one, or place them along the seamlines.</source>
        <translation>Nie ma jeszcze okien: narysuj okno albo rozmieść je wzdłuż linii mozaikowania.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/dock.py" line="358"/>
        <source>No scan has found such places yet: scan the mosaic first.</source>
        <translation>Żadne badanie nie znalazło jeszcze takich miejsc: najpierw zbadaj ortofotomapę.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/dock.py" line="355"/>
        <source>No window has been inspected yet.</source>
        <translation>Żadne okno nie zostało jeszcze skontrolowane.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/session.py" line="66"/>
        <source>Lost detail</source>
        <translation>Utracone detale</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/map/window_tool.py" line="169"/>
        <source>window {number}: click selects it, drag draws another</source>
        <translation>okno {number}: kliknięcie zaznacza je, przeciągnięcie rysuje nowe</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/desk_keys.py" line="74"/>
        <source>Redo</source>
        <translation>Ponów zmianę</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/windows/window_columns.py" line="140"/>
        <source>observer 2</source>
        <translation>obserwator 2</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/windows/window_columns.py" line="140"/>
        <source>What the second operator saw at 2x magnification.</source>
        <translation>Co drugi operator widział w powiększeniu 2×.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/windows/window_columns.py" line="142"/>
        <source>The observer&apos;s remark.</source>
        <translation>Uwaga obserwatora.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/measure/window/window_tables.py" line="138"/>
        <source>remark 2</source>
        <translation>uwaga 2</translation>
    </message>
    <message>
        <location filename="../plugin/toolkit/layer_styles.py" line="52"/>
        <source>all causes</source>
        <translation>wszystkie przyczyny</translation>
    </message>
    <message>
        <location filename="../plugin/toolkit/layer_styles.py" line="29"/>
        <source>seam</source>
        <translation>linia</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/windows/windows_panel.py" line="66"/>
        <source>Windows where the observer was not sure.</source>
        <translation>Okna, których obserwator nie był pewien.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/windows/window_columns.py" line="126"/>
        <source>paper</source>
        <translation>artykuł</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/windows/window_columns.py" line="127"/>
        <source>The paper&apos;s own flag, by ratio 1 against whole sources, whatever the verdict is based on.</source>
        <translation>Oznaczenie według samego artykułu: stosunek 1 względem całych ortoobrazów, niezależnie od podstawy oceny.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/mosaic_scans.py" line="65"/>
        <source>A scan is under way; it can be stopped below.</source>
        <translation>Badanie trwa; można je zatrzymać poniżej.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/inputs/inputs_panel.py" line="132"/>
        <source>check the sources</source>
        <translation>zaznacz ortoobrazy</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/inputs/inputs_panel.py" line="141"/>
        <source>Inputs: {missing}</source>
        <translation>Dane wejściowe: {missing}</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/inputs/sources.py" line="265"/>
        <source>suggested</source>
        <translation>proponowane</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/inputs/sources.py" line="265"/>
        <source>Tick only the rasters that may be sources of this mosaic</source>
        <translation>Zaznacz tylko te rastry, które mogą być źródłami tej ortofotomapy</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/inputs/sources.py" line="237"/>
        <source>floating point</source>
        <translation>zmiennoprzecinkowe</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/inputs/sources.py" line="237"/>
        <source>{bits} bit</source>
        <translation>{bits}-bitowe</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/messages.py" line="13"/>
        <source>The windows moved beside the project, to {path}.</source>
        <translation>Okna przeniesiono obok projektu, do {path}.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/measure/messages.py" line="362"/>
        <source>The mosaic itself.</source>
        <translation>Sama ortofotomapa.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/measure/messages.py" line="363"/>
        <source>Does not overlap the mosaic.</source>
        <translation>Nie nachodzi na ortofotomapę.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/measure/messages.py" line="364"/>
        <source>Other bands, {bands} and not {mosaic}: heights, a mask or a map.</source>
        <translation>Inne kanały, {bands} zamiast {mosaic}: wysokości, maska albo mapa.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/measure/messages.py" line="365"/>
        <source>Pixels {factor:.1f} times as large as the mosaic&apos;s: an overview or a map.</source>
        <translation>Piksele {factor:.1f} raza większe niż w ortofotomapie: przegląd albo mapa.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/measure/messages.py" line="366"/>
        <source>Pixels {factor:.1f} times smaller than the mosaic&apos;s: another flight.</source>
        <translation>Piksele {factor:.1f} raza mniejsze niż w ortofotomapie: inny nalot.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/measure/messages.py" line="367"/>
        <source>In another reference system than the mosaic and others here: a reprojected copy.</source>
        <translation>W innym układzie współrzędnych niż ortofotomapa i inne rastry: kopia po przeliczeniu układu.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/measure/messages.py" line="368"/>
        <source>Pixels of {own}, the mosaic&apos;s and others&apos; are {mosaic}: a converted copy.</source>
        <translation>Piksele {own}, a w ortofotomapie i innych rastrach {mosaic}: kopia po konwersji.</translation>
    </message>
    <message>
        <source>90 % and more: even ground</source>
        <translation>90 % i więcej: jak teren wokół</translation>
    </message>
    <message>
        <source>at most half of the finest detail would stay</source>
        <translation>zostałaby najwyżej połowa najdrobniejszych detali</translation>
    </message>
    <message>
        <source>up to three quarters</source>
        <translation>do trzech czwartych</translation>
    </message>
    <message>
        <source>more than three quarters</source>
        <translation>ponad trzy czwarte</translation>
    </message>
    <message>
        <source>nothing to be feathered, or not comparable</source>
        <translation>nic do wtapiania albo nieporównywalne</translation>
    </message>
    <message>
        <source>significant loss</source>
        <translation>istotna strata</translation>
    </message>
    <message>
        <source>Window</source>
        <translation>Okno</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/judge_bar.py" line="122"/>
        <source>Window {number}: {percent} % sure</source>
        <translation>Okno {number}: {percent} % pewności</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/windows/windows_panel.py" line="242"/>
        <source>Remove {count} windows, {judged} of them judged?</source>
        <translation>Usunąć {count} {count:okno|okna|okien}, w tym {judged} {judged:ocenione|ocenione|ocenionych}?</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/dock.py" line="311"/>
        <source>Results are hidden while you judge blind.</source>
        <translation>Wyniki są ukryte, dopóki oceniasz w ciemno.</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/paper/inspection_record.py" line="78"/>
        <source>wavelet</source>
        <translation>falka</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/paper/inspection_record.py" line="78"/>
        <source>levels</source>
        <translation>liczba poziomów</translation>
    </message>
    <message>
        <location filename="../plugin/noise/report.py" line="62"/>
        <source>mean detail {level}</source>
        <translation>średnie detale {level}</translation>
    </message>
    <message>
        <location filename="../plugin/noise/report.py" line="63"/>
        <source>mean sigma (DN)</source>
        <translation>średnia sigma (DN)</translation>
    </message>
    <message>
        <location filename="../plugin/noise/report.py" line="140"/>
        <source>largest possible</source>
        <translation>największa możliwa</translation>
    </message>
    <message>
        <location filename="../plugin/noise/report.py" line="140"/>
        <source>grain (DN)</source>
        <translation>ziarno (DN)</translation>
    </message>
    <message>
        <location filename="../plugin/noise/checknoise.py" line="58"/>
        <source>Name of the rasters</source>
        <translation>Nazwa rastrów</translation>
    </message>
    <message>
        <location filename="../plugin/noise/checknoise.py" line="59"/>
        <source>What the first group is called in chart and report. Empty: its file&apos;s name, or group 1.</source>
        <translation>Nazwa pierwszej grupy na wykresie i w raporcie. Puste: nazwa jej pliku albo grupa 1.</translation>
    </message>
    <message>
        <location filename="../plugin/noise/checknoise.py" line="61"/>
        <source>Name of the second group</source>
        <translation>Nazwa drugiej grupy</translation>
    </message>
    <message>
        <location filename="../plugin/noise/checknoise.py" line="62"/>
        <source>What the second group is called. Empty: its file&apos;s name, or group 2.</source>
        <translation>Nazwa drugiej grupy. Puste: nazwa jej pliku albo grupa 2.</translation>
    </message>
    <message>
        <location filename="../plugin/noise/checknoise.py" line="68"/>
        <source>Group windows by</source>
        <translation>Grupuj okna według</translation>
    </message>
    <message>
        <location filename="../plugin/noise/checknoise.py" line="27"/>
        <source>Windows whose texture could hide grain</source>
        <translation>Okna, których tekstura może skrywać ziarno</translation>
    </message>
    <message>
        <location filename="../plugin/noise/checknoise.py" line="103"/>
        <source>group {group}</source>
        <translation>grupa {group}</translation>
    </message>
    <message>
        <location filename="../plugin/noise/noise_summary.py" line="24"/>
        <source>uncertain</source>
        <translation>niepewny</translation>
    </message>
    <message>
        <location filename="../plugin/noise/noise_summary.py" line="107"/>
        <source>no value</source>
        <translation>brak wartości</translation>
    </message>
    <message>
        <location filename="../plugin/noise/measure/messages.py" line="9"/>
        <source>GROUP_FIELD is a field of the windows; give WINDOWS, or leave GROUP_FIELD empty.</source>
        <translation>Okna są grupowane według ich pola; podaj WINDOWS albo pozostaw GROUP_FIELD puste.</translation>
    </message>
    <message>
        <location filename="../plugin/noise/measure/messages.py" line="11"/>
        <source>The windows have no field {field}; choose one that they have.</source>
        <translation>Okna nie mają pola {field}; wybierz jedno z pól, które mają.</translation>
    </message>
    <message>
        <location filename="../plugin/noise/measure/messages.py" line="35"/>
        <source>The quiet ground has the spectrum of grain, noise coarser than a pixel; the curve alone does not show it.</source>
        <translation>Spokojny teren ma widmo ziarna, czyli szumu grubszego niż piksel; sama krzywa tego nie pokazuje.</translation>
    </message>
    <message>
        <location filename="../plugin/noise/measure/messages.py" line="38"/>
        <source>The curve rises, but noise coarser than a pixel (grain) can hide in this texture; measure smoother ground.</source>
        <translation>Krzywa rośnie, ale w tej teksturze może się kryć szum grubszy niż piksel (ziarno); zmierz gładszy teren.</translation>
    </message>
    <message>
        <location filename="../plugin/noise/charts.py" line="97"/>
        <source>{field}: {value}</source>
        <translation>{field}: {value}</translation>
    </message>
    <message>
        <location filename="../plugin/noise/charts.py" line="98"/>
        <source>All windows, {band}</source>
        <translation>Wszystkie okna, {band}</translation>
    </message>
    <message>
        <location filename="../plugin/noise/charts.py" line="121"/>
        <source>1 window</source>
        <translation>1 okno</translation>
    </message>
    <message>
        <location filename="../plugin/noise/charts.py" line="122"/>
        <source>{name}: mean and range of {count} windows</source>
        <translation>{name}: średnia i zakres {count} {count:okna|okien|okien}</translation>
    </message>
    <message>
        <location filename="../plugin/toolkit/layers.py" line="103"/>
        <source>temporary layer</source>
        <translation>warstwa tymczasowa</translation>
    </message>
    <message>
        <location filename="../plugin/toolkit/pages/templates.py" line="84"/>
        <source>about {size:.3g} m</source>
        <translation>około {size:.3g} m</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/report.py" line="113"/>
        <source>reference system of the points</source>
        <translation>układ współrzędnych punktów</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/measure/messages.py" line="8"/>
        <source>No point is left to fit a model to: {why} Correct the layer, or choose another one.</source>
        <translation>Nie ma już punktów do dopasowania modelu: {why} Popraw warstwę albo wybierz inną.</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/measure/messages.py" line="26"/>
        <source>By their reference system the points are in degrees, but one is at {x:.10g}, {y:.10g}; set the reference system that their coordinates are in.</source>
        <translation>Punkty mają być w stopniach, a jeden leży w {x:.10g}; {y:.10g}; ustaw układ współrzędnych, w którym podano ich współrzędne.</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/measure/messages.py" line="29"/>
        <source>According to the points a pixel measures {size:.2g} m on the ground; check that their reference system is the one that their coordinates are in.</source>
        <translation>Według punktów piksel ma w terenie {size:.2g} m; sprawdź, czy ich układ współrzędnych jest tym, w którym podano współrzędne.</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/measure/messages.py" line="32"/>
        <source>The points&apos; rows are negative, as QGIS&apos;s georeferencer shows them; give them from the upper edge downwards, all positive, or the .points file itself.</source>
        <translation>Wiersze punktów są ujemne, jak pokazuje je georeferencer QGIS; podaj je od górnej krawędzi w dół, wszystkie dodatnie, albo podaj sam plik .points.</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/measure/messages.py" line="37"/>
        <source>{count} points lie outside the image of {columns} x {rows} pixels ({names}); correct or remove them, or choose their image.</source>
        <translation>Poza obrazem {columns} × {rows} px {count:leży|leżą|leży} {count} {count:punkt|punkty|punktów} ({names}); popraw je lub usuń albo wybierz właściwy obraz.</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/measure/messages.py" line="49"/>
        <source>The image&apos;s RPC sees the points {distance:.3g} px away from the image; check that x and y are not interchanged, their reference system and heights, and that it is the RPC of this image.</source>
        <translation>Według RPC punkty leżą {distance:.3g} px poza obrazem; sprawdź, czy x i y nie są zamienione, ich układ współrzędnych i wysokości oraz czy jest to RPC tego obrazu.</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/measure/messages.py" line="52"/>
        <source>According to the image&apos;s RPC the points are measured in a mirrored or turned image; count columns and rows from the upper left corner of the image that the RPC belongs to.</source>
        <translation>Według RPC obrazu punkty zmierzono na obrazie odbitym lub obróconym; licz kolumny i wiersze od lewego górnego narożnika obrazu, do którego należy RPC.</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/measure/messages.py" line="99"/>
        <source>The RPC is off by {columns:.2f} columns and {rows:.2f} rows in the middle of the image, by {most:.2f} px where it is worst; the model corrects that.</source>
        <translation>RPC jest przesunięte w środku obrazu o {columns:.2f} kolumny i {rows:.2f} wiersza, a w najgorszym miejscu o {most:.2f} px; model to koryguje.</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/measure/messages.py" line="109"/>
        <source>No image with the RPC is written, as there is no image to copy; choose the image.</source>
        <translation>Nie zapisano obrazu z RPC: nie ma obrazu do skopiowania; wybierz go.</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/measure/messages.py" line="124"/>
        <source>The camera of {name} has {width} x {height} pixels and the image {columns} x {rows}, which is another shape; choose the camera&apos;s own image, uncropped and not turned.</source>
        <translation>Kamera z pliku {name} ma {width} × {height} pikseli, a obraz {columns} × {rows}, czyli inny kształt; wybierz obraz tej kamery, nieprzycięty i nieobrócony.</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/measure/messages.py" line="144"/>
        <source>{name} holds several cameras ({names}) and the exterior orientation names none of them; leave one in the file.</source>
        <translation>Plik {name} zawiera kilka kamer ({names}), a orientacja zewnętrzna żadnej z nich nie wymienia; zostaw w pliku jedną.</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/measure/messages.py" line="152"/>
        <source>{name} does not name the image {image} exactly once; it names {names}. Choose the file of this image.</source>
        <translation>{name} nie wymienia obrazu {image} dokładnie raz; wymienia: {names}. Wybierz plik tego obrazu.</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/measure/messages.py" line="166"/>
        <source>The camera of {name} is at {height:.0f} m, not above the terrain at {low:.0f} to {high:.0f} m; check the heights, their units and the reference system.</source>
        <translation>Kamera zdjęcia {name} jest na wysokości {height:.0f} m, a nie ponad terenem o wysokości od {low:.0f} do {high:.0f} m; sprawdź wysokości, ich jednostki i układ współrzędnych.</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/measure/messages.py" line="171"/>
        <source>The camera of {name} looks at the horizon or above it, so that a part of the image has no place on the ground; check omega, phi and kappa.</source>
        <translation>Kamera zdjęcia {name} patrzy na horyzont lub ponad niego, więc część obrazu nie ma miejsca w terenie; sprawdź omega, phi i kappa.</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/measure/messages.py" line="176"/>
        <source>The terrain model {name} has no heights at all; choose another one.</source>
        <translation>NMT {name} nie zawiera żadnych wysokości; wybierz inny.</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/measure/messages.py" line="177"/>
        <source>The exterior orientation is taken as in the image&apos;s own reference system.</source>
        <translation>Przyjęto, że orientacja zewnętrzna jest w układzie współrzędnych obrazu.</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/measure/messages.py" line="185"/>
        <source>{name} is not a geoid grid (heights of sea level above the ellipsoid, m, rows from north to south); choose one, such as a .gtx or .tif of PROJ.</source>
        <translation>{name} nie jest siatką geoidy (wysokości poziomu morza nad elipsoidą, m, wiersze z północy na południe); wybierz taką, np. plik .gtx lub .tif z PROJ.</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/measure/messages.py" line="187"/>
        <source>The grid {name} has no values at some of the places; choose one that covers them.</source>
        <translation>Siatka {name} nie ma wartości w niektórych z tych miejsc; wybierz siatkę, która je obejmuje.</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/measure/messages.py" line="206"/>
        <source>The image was taken {angle:.1f} degrees from the vertical (at most {largest:.1f} in its corners) from azimuth {azimuth:.0f}; an error of {error:g} m in the terrain&apos;s heights moves its middle by {shift:.2f} m.</source>
        <translation>Obraz wykonano pod kątem {angle:.1f}° od pionu (w narożnikach najwyżej {largest:.1f}°), z azymutu {azimuth:.0f}°; błąd wysokości terenu {error:g} m przesuwa jego środek o {shift:.2f} m.</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/measure/messages.py" line="216"/>
        <source>The numbers of control points are &apos;{given}&apos;; give whole numbers from 1 to {most}, such as 6, 10, 20.</source>
        <translation>Jako liczby fotopunktów podano „{given}”; podaj liczby całkowite od 1 do {most}, na przykład 6, 10, 20.</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/measure/messages.py" line="218"/>
        <source>The image has no RPC to plan by; give the file that came with it, or leave the image out for a nominal scanner.</source>
        <translation>Obraz nie ma RPC, według którego można planować; podaj plik dostarczony z obrazem albo nie podawaj obrazu, aby przyjąć skaner nominalny.</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/measure/messages.py" line="220"/>
        <source>With {count} control points expect {usual:.2f} m over the image; nine times in ten at most {most:.2f} m.</source>
        <translation>{count} {count:fotopunkt|fotopunkty|fotopunktów}: oczekiwany błąd na obrazie {usual:.2f} m, w dziewięciu przypadkach na dziesięć najwyżej {most:.2f} m.</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/measure/messages.py" line="221"/>
        <source>With {count} control points {failed} draws failed and count as the worst: {why}</source>
        <translation>{count} {count:fotopunkt|fotopunkty|fotopunktów}: nieudane losowania ({failed}) liczą się jako najgorsze: {why}</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/fitsensormodel.py" line="237"/>
        <source>Plan control points</source>
        <translation>Zaplanuj fotopunkty</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/fitsensormodel.py" line="239"/>
        <source>Predicts the accuracy from the number, quality and spread of control points before they are measured. For every number of points 50 sets with random errors are drawn on an image whose geometry is known, its RPC or that of a nominal line scanner; the model is fitted to each and judged all over the image. This is a planning figure; your own check points show how accurate the image is.</source>
        <translation>Mówi, jakiej dokładności oczekiwać po liczbie, jakości i rozmieszczeniu fotopunktów, zanim zostaną pomierzone. Dla każdej liczby punktów losuje się 50 zestawów z błędami przypadkowymi na obrazie o znanej geometrii: według jego RPC albo nominalnego skanera liniowego; model dopasowuje się do każdego i ocenia na całym obrazie. To liczba do planowania: o uzyskanej dokładności mówią dopiero własne punkty kontrolne.</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/fitsensormodel.py" line="248"/>
        <source>Numbers of control points</source>
        <translation>Liczby fotopunktów</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/fitsensormodel.py" line="250"/>
        <source>One row of the table for each, such as 6, 10, 20. Check points are not counted.</source>
        <translation>Jeden wiersz tabeli na każdą z nich, na przykład 6, 10, 20. Punktów kontrolnych się nie wlicza.</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/fitsensormodel.py" line="252"/>
        <source>Spread</source>
        <translation>Rozmieszczenie</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/fitsensormodel.py" line="253"/>
        <source>grid: one point in each cell of a grid over the image; random: anywhere; corner: all in one corner.</source>
        <translation>grid: po jednym punkcie w każdym oczku siatki na obrazie; random: gdziekolwiek; corner: wszystkie w jednym narożniku.</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/fitsensormodel.py" line="256"/>
        <source>Share of the corner</source>
        <translation>Część obrazu w narożniku</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/fitsensormodel.py" line="256"/>
        <source>Share of the image, for the spread corner.</source>
        <translation>Część powierzchni obrazu, dla rozmieszczenia corner.</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/fitsensormodel.py" line="257"/>
        <source>Standard deviation on the ground (metres)</source>
        <translation>Odchylenie standardowe w terenie (metry)</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/fitsensormodel.py" line="259"/>
        <source>Standard deviation in the image (pixels)</source>
        <translation>Odchylenie standardowe na obrazie (piksele)</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/fitsensormodel.py" line="260"/>
        <source>For a point&apos;s column and row: how well it is identified.</source>
        <translation>Kolumny i wiersza punktu: jak dobrze się go rozpoznaje.</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/fitsensormodel.py" line="264"/>
        <source>Lowest terrain (metres)</source>
        <translation>Najniższy teren (metry)</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/fitsensormodel.py" line="265"/>
        <source>Highest terrain (metres)</source>
        <translation>Najwyższy teren (metry)</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/fitsensormodel.py" line="268"/>
        <source>An RPC whose geometry is taken as true. Without it and without IMAGE: a nominal line scanner.</source>
        <translation>RPC, którego geometrię przyjmuje się za prawdziwą. Bez niego i bez IMAGE: nominalny skaner liniowy.</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/fitsensormodel.py" line="272"/>
        <source>For the nominal scanner and the model pushbroom.</source>
        <translation>Skanera nominalnego oraz modelu pushbroom.</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/fitsensormodel.py" line="273"/>
        <source>Angle of the view (degrees)</source>
        <translation>Kąt wychylenia (stopnie)</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/fitsensormodel.py" line="273"/>
        <source>From the vertical; nominal scanner.</source>
        <translation>Od pionu; skaner nominalny.</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/checkdelivery.py" line="54"/>
        <source>Pixel size (metres)</source>
        <translation>Wielkość piksela (metry)</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/fitsensormodel.py" line="274"/>
        <source>On the ground; nominal scanner.</source>
        <translation>W terenie; skaner nominalny.</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/fitsensormodel.py" line="275"/>
        <source>Side of the image (km)</source>
        <translation>Bok obrazu (km)</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/fitsensormodel.py" line="275"/>
        <source>The image is square; nominal scanner.</source>
        <translation>Obraz jest kwadratowy; skaner nominalny.</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/stated_rules.py" line="123"/>
        <source>Seed</source>
        <translation>Ziarno losowania</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/fitsensormodel.py" line="279"/>
        <source>The same number gives the same draws.</source>
        <translation>Ta sama liczba daje te same losowania.</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/fitsensormodel.py" line="280"/>
        <source>Expected accuracy</source>
        <translation>Oczekiwana dokładność</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/fitsensormodel.py" line="281"/>
        <source>One row per number of points: root mean square errors in metres, of both coordinates together, that 50 % and 90 % of the draws do not exceed: over the whole image, and at check points that are measured as well as the control points.</source>
        <translation>Jeden wiersz na liczbę punktów: błędy średniokwadratowe w metrach, dla obu współrzędnych łącznie, których nie przekracza 50 % i 90 % losowań: na całym obrazie oraz na punktach kontrolnych pomierzonych tak dobrze jak fotopunkty.</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/sensor_parameters.py" line="101"/>
        <source>Angle of the view from the vertical, in the middle of the image (degrees)</source>
        <translation>Kąt wychylenia od pionu w środku obrazu (stopnie)</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/sensor_parameters.py" line="102"/>
        <source>Azimuth that the image was taken from (degrees)</source>
        <translation>Azymut, z którego wykonano obraz (stopnie)</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/sensor_parameters.py" line="103"/>
        <source>Displacement of the image&apos;s middle by the error of terrain heights (m)</source>
        <translation>Przesunięcie środka obrazu wskutek błędu wysokości terenu (m)</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/sensor_parameters.py" line="61"/>
        <source>What the heights refer to: auto takes what the reference system says, and the ellipsoid with a warning where it says nothing; egm96 and egm2008 (heights above sea level) are converted if PROJ has the grid, geoid by a grid file of your own. SRTM tiles are egm96.</source>
        <translation>Do czego odnoszą się wysokości: auto przyjmuje to, co podaje układ współrzędnych, a gdy nie podaje nic, elipsoidę z ostrzeżeniem; egm96 i egm2008 (wysokości nad poziomem morza) są przeliczane, jeśli PROJ ma odpowiednią siatkę, a geoid – według własnego pliku siatki. Kafle SRTM to egm96.</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/sensor_parameters.py" line="71"/>
        <source>Error of terrain heights (metres)</source>
        <translation>Błąd wysokości terenu (metry)</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/sensor_parameters.py" line="72"/>
        <source>The log says how far an error of this size moves the orthoimage, by the angle that the image was taken at.</source>
        <translation>Podaje się, o ile błąd tej wielkości przesuwa ortoobraz, z kąta, pod którym wykonano obraz.</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/sensor_parameters.py" line="65"/>
        <source>Grid of the geoid</source>
        <translation>Siatka geoidy</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/sensor_parameters.py" line="66"/>
        <source>For heights that refer to geoid: how far sea level is above the ellipsoid, as .gtx, .tif or any raster.</source>
        <translation>Dla wysokości odniesionych do geoidy: jak wysoko poziom morza leży nad elipsoidą, jako .gtx, .tif lub dowolny raster.</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/fitsensormodel.py" line="83"/>
        <source>RPC files (*.txt *.TXT *.rpb *.RPB)</source>
        <translation>Pliki RPC (*.txt *.TXT *.rpb *.RPB)</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/fitsensormodel.py" line="84"/>
        <source>The model as RPC. GDAL reads it beside image.tif under the name image_RPC.TXT or image.RPB.</source>
        <translation>Model w postaci RPC. GDAL odczytuje go obok pliku image.tif pod nazwą image_RPC.TXT lub image.RPB.</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/fitsensormodel.py" line="85"/>
        <source>Image with the RPC</source>
        <translation>Obraz z RPC</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/fitsensormodel.py" line="86"/>
        <source>A copy of the image that carries the model as RPC in its tags, and no other georeference.</source>
        <translation>Kopia obrazu, która zawiera model jako RPC w znacznikach pliku i nie ma innej georeferencji.</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/fitsensormodel.py" line="87"/>
        <source>Points for the georeferencer</source>
        <translation>Punkty dla georeferencera</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/fitsensormodel.py" line="87"/>
        <source>GCP files (*.points)</source>
        <translation>Pliki fotopunktów (*.points)</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/fitsensormodel.py" line="88"/>
        <source>The points with their residuals in pixels; check points and blunders are switched off.</source>
        <translation>Punkty z odchyłkami w pikselach; punkty kontrolne i błędy grube są wyłączone.</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/fitsensormodel.py" line="102"/>
        <source>Correction of the RPC in the middle of the image, columns (px)</source>
        <translation>Poprawka RPC w środku obrazu, kolumny (px)</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/fitsensormodel.py" line="103"/>
        <source>Correction of the RPC in the middle of the image, rows (px)</source>
        <translation>Poprawka RPC w środku obrazu, wiersze (px)</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/orthorectify.py" line="125"/>
        <source>Puts an image on the map over a terrain model: a satellite image by a model file of Fit sensor model, an RPC file or its own RPC, an aerial photo by its interior and exterior orientation. GDAL&apos;s warper does it with all cores; how far it is from the exact model is measured on a grid and reported. Heights above sea level are brought to the ellipsoid, as RPCs want them.</source>
        <translation>Umieszcza obraz na mapie z użyciem NMT: obraz satelitarny według pliku modelu z algorytmu „Dopasuj model sensora”, pliku RPC albo własnego RPC, zdjęcie lotnicze według orientacji wewnętrznej i zewnętrznej. Przepróbkowanie wykonuje GDAL na wszystkich rdzeniach; odległość od modelu dokładnego jest mierzona na siatce i podawana. Wysokości nad poziomem morza są sprowadzane do elipsoidy, jak wymagają tego RPC.</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/orthorectify.py" line="47"/>
        <source>Exterior orientation</source>
        <translation>Orientacja zewnętrzna</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/orthorectify.py" line="58"/>
        <source>Reference system of the exterior orientation</source>
        <translation>Układ współrzędnych orientacji zewnętrznej</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/orthorectify.py" line="60"/>
        <source>Projected, in metres. Empty: what its file says, else the image&apos;s own.</source>
        <translation>Płaski prostokątny, w metrach. Puste pole: ten, który podaje jej plik, a w przeciwnym razie układ obrazu.</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/orthorectify.py" line="62"/>
        <source>Heights of the exterior orientation</source>
        <translation>Wysokości orientacji zewnętrznej</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/orthorectify.py" line="64"/>
        <source>as_terrain: they refer to what the terrain model&apos;s heights refer to, and nothing is converted.</source>
        <translation>as_terrain: odnoszą się do tego, do czego odnoszą się wysokości NMT, i nic nie jest przeliczane.</translation>
    </message>
    <message>
        <location filename="../plugin/imagery/messages.py" line="107"/>
        <source>{name} has &apos;{key}&apos; twice in one object; keep one.</source>
        <translation>W pliku {name} klucz „{key}” występuje dwa razy w jednym obiekcie; zostaw jeden.</translation>
    </message>
    <message>
        <location filename="../plugin/imagery/messages.py" line="109"/>
        <source>{place} in {name} has the unknown {key} &apos;{value}&apos;; known are {known}.</source>
        <translation>{place} w pliku {name}: nieznana wartość „{value}” klucza {key}; znane są {known}.</translation>
    </message>
    <message>
        <location filename="../plugin/imagery/messages.py" line="110"/>
        <source>{place} in {name}: &apos;{key}&apos; has to be a number of {least:g} or more.</source>
        <translation>{place} w pliku {name}: „{key}” musi być liczbą nie mniejszą niż {least:g}.</translation>
    </message>
    <message>
        <location filename="../plugin/imagery/messages.py" line="112"/>
        <source>{place} in {name}: &apos;{key}&apos; has to be a whole number of 1 or more.</source>
        <translation>{place} w pliku {name}: „{key}” musi być liczbą całkowitą nie mniejszą niż 1.</translation>
    </message>
    <message>
        <location filename="../plugin/imagery/messages.py" line="113"/>
        <source>{place} in {name}: &apos;{key}&apos; has to be true or false.</source>
        <translation>{place} w pliku {name}: „{key}” musi mieć wartość true lub false.</translation>
    </message>
    <message>
        <location filename="../plugin/resolution/distance_words.py" line="30"/>
        <source>geometric mean</source>
        <translation>średnia geometryczna</translation>
    </message>
    <message>
        <location filename="../plugin/resolution/report.py" line="100"/>
        <source>all of them</source>
        <translation>wszyscy razem</translation>
    </message>
    <message>
        <location filename="../plugin/resolution/report.py" line="107"/>
        <source>Ground resolved distance: one bar of the finest group that is resolved in every band.</source>
        <translation>Terenowa zdolność rozdzielcza: jeden pasek najdrobniejszej grupy, która jest rozróżniona w każdym kanale.</translation>
    </message>
    <message>
        <location filename="../plugin/resolution/report.py" line="108"/>
        <source>Ground resolved distance: one bar and one gap of the finest group that is resolved in every band.</source>
        <translation>Terenowa zdolność rozdzielcza: jeden pasek i jedna przerwa najdrobniejszej grupy, która jest rozróżniona w każdym kanale.</translation>
    </message>
    <message>
        <location filename="../plugin/resolution/report.py" line="112"/>
        <source>higher</source>
        <translation>wyższy</translation>
    </message>
    <message>
        <location filename="../plugin/resolution/report.py" line="112"/>
        <source>lower</source>
        <translation>niższy</translation>
    </message>
    <message>
        <location filename="../plugin/resolution/report.py" line="113"/>
        <source>the group&apos;s own bars against plain gaps</source>
        <translation>własne paski grupy względem gładkich przerw</translation>
    </message>
    <message>
        <location filename="../plugin/resolution/report.py" line="113"/>
        <source>that of the coarsest group</source>
        <translation>amplituda najgrubszej grupy</translation>
    </message>
    <message>
        <location filename="../plugin/resolution/report.py" line="115"/>
        <source>group {group} is {grd:.2f} cm wide, the next {coarser} number {step:.3f} times as wide</source>
        <translation>szerokość grupy {group} wynosi {grd:.2f} cm, a grupa o następnym numerze ({coarser}) jest {step:.3f} razy szersza</translation>
    </message>
    <message>
        <location filename="../plugin/resolution/report.py" line="117"/>
        <source>bars in each group</source>
        <translation>paski w każdej grupie</translation>
    </message>
    <message>
        <location filename="../plugin/resolution/report.py" line="118"/>
        <source>widths</source>
        <translation>szerokości</translation>
    </message>
    <message>
        <location filename="../plugin/resolution/report.py" line="120"/>
        <source>widths are of</source>
        <translation>szerokości dotyczą</translation>
    </message>
    <message>
        <location filename="../plugin/resolution/desk/bar_dock.py" line="69"/>
        <source>one bar</source>
        <translation>jeden pasek</translation>
    </message>
    <message>
        <location filename="../plugin/resolution/report.py" line="120"/>
        <source>a bar and a gap together</source>
        <translation>pasek i przerwa razem</translation>
    </message>
    <message>
        <location filename="../plugin/resolution/report.py" line="121"/>
        <source>criterion</source>
        <translation>kryterium</translation>
    </message>
    <message>
        <location filename="../plugin/resolution/report.py" line="122"/>
        <source>full amplitude</source>
        <translation>pełna amplituda</translation>
    </message>
    <message>
        <location filename="../plugin/resolution/desk/bar_dock.py" line="69"/>
        <source>bar and gap</source>
        <translation>pasek i przerwa</translation>
    </message>
    <message>
        <location filename="../plugin/resolution/desk/bar_dock.py" line="70"/>
        <source>of the group</source>
        <translation>danej grupy</translation>
    </message>
    <message>
        <location filename="../plugin/resolution/desk/bar_dock.py" line="70"/>
        <source>of the coarsest group</source>
        <translation>najgrubszej grupy</translation>
    </message>
    <message>
        <location filename="../plugin/resolution/desk/bar_dock.py" line="73"/>
        <source>Distance of the reference group: the width of what is chosen beside it.</source>
        <translation>GRD grupy odniesienia: szerokość tego, co wybrano obok.</translation>
    </message>
    <message>
        <location filename="../plugin/resolution/desk/bar_dock.py" line="75"/>
        <source>What a distance measures: a bar and a gap together, as resolution is defined, or one bar, as some targets and reports count.</source>
        <translation>Czego szerokością jest wymiar: paska i przerwy razem, zgodnie z definicją rozdzielczości, czy jednego paska, jak w niektórych testach i raportach.</translation>
    </message>
    <message>
        <location filename="../plugin/resolution/desk/bar_dock.py" line="79"/>
        <source>What the amplitude has to be half of: the group&apos;s own bars against plain gaps, or the full amplitude of the coarsest group, which is stricter.</source>
        <translation>Połową czego musi być amplituda: własnych pasków grupy względem gładkich przerw czy pełnej amplitudy najgrubszej grupy, co jest surowsze.</translation>
    </message>
    <message>
        <location filename="../plugin/resolution/desk/bar_dock.py" line="96"/>
        <source>Full amplitude</source>
        <translation>Pełna amplituda</translation>
    </message>
    <message>
        <location filename="../plugin/resolution/distance_words.py" line="64"/>
        <source>Group {group}, {distance}</source>
        <translation>Grupa {group}, {distance}</translation>
    </message>
    <message>
        <location filename="../plugin/resolution/distance_words.py" line="69"/>
        <source>(amplitude {share:.0%} of the full one)</source>
        <translation>(amplituda {share:.0%} pełnej)</translation>
    </message>
    <message>
        <location filename="../plugin/resolution/distance_words.py" line="73"/>
        <source>All lines: {distances}</source>
        <translation>Wszystkie linie: {distances}</translation>
    </message>
    <message>
        <location filename="../plugin/resolution/measure/messages.py" line="24"/>
        <source>Group {group} is too far from the reference group {reference} to have a width; correct one of the numbers.</source>
        <translation>Grupa {group} jest za daleko od grupy odniesienia {reference}, by mieć szerokość; popraw jeden z numerów.</translation>
    </message>
    <message>
        <location filename="../plugin/resolution/measure/messages.py" line="58"/>
        <source>Bars and gaps of the coarsest group differ by a factor of {contrast:.1f} and the method asks for {least:g} at least, so the distance may be coarser than the sensor&apos;s best; haze and a low sun lower the contrast.</source>
        <translation>Paski i przerwy najgrubszej grupy różnią się {contrast:.1f} razy, a metoda wymaga co najmniej {least:g}, więc GRD może być gorsza od najlepszej dla tego sensora; zamglenie i niskie słońce obniżają kontrast.</translation>
    </message>
    <message>
        <location filename="../plugin/resolution/measure/messages.py" line="61"/>
        <source>No plain area of the target shows the full amplitude, so the groups may seem better resolved than they are; draw lines across coarser groups too.</source>
        <translation>Żadne jednolite miejsce testu nie wyznacza pełnej amplitudy, więc grupy mogą wydawać się lepiej rozróżnione, niż są; narysuj też linie w poprzek grubszych grup.</translation>
    </message>
    <message>
        <location filename="../plugin/resolution/measure/messages.py" line="67"/>
        <source>None of the {count} lines shows bars that can be measured, so there is no ground resolved distance; draw each across the bars of one group, on the image.</source>
        <translation>Żadna z narysowanych linii (liczba: {count}) nie pokazuje pasków, które można zmierzyć, więc nie ma terenowej zdolności rozdzielczej; narysuj każdą na obrazie w poprzek pasków jednej grupy.</translation>
    </message>
    <message>
        <location filename="../plugin/resolution/measure/messages.py" line="75"/>
        <source>The reference height is {height:g} m; give a positive number of metres up to {highest:g}, or leave it empty.</source>
        <translation>Wysokość odniesienia wynosi {height:g} m; podaj dodatnią liczbę metrów do {highest:g} albo pozostaw pole puste.</translation>
    </message>
    <message>
        <location filename="../plugin/resolution/measure/messages.py" line="80"/>
        <source>Height {height:g} m and distance {grd:g} cm give no minimum height; give positive numbers, metres up to {highest:g} and centimetres from {least:g} to {most:g}.</source>
        <translation>Z wysokości {height:g} m i GRD {grd:g} cm nie można obliczyć minimalnej wysokości; podaj liczby dodatnie: metry do {highest:g} i centymetry od {least:g} do {most:g}.</translation>
    </message>
    <message>
        <location filename="../plugin/resolution/measure/messages.py" line="83"/>
        <source>A distance of {grd:g} cm from a height of {height:g} m is coarser than that of any camera; &apos;height&apos; is in metres and &apos;grd&apos; in centimetres, so check whether both are interchanged.</source>
        <translation>Zdolność {grd:g} cm z wysokości {height:g} m jest gorsza niż jakiejkolwiek kamery; „height” jest w metrach, a „grd” w centymetrach, sprawdź więc, czy nie są zamienione.</translation>
    </message>
    <message>
        <location filename="../plugin/resolution/measure/messages.py" line="86"/>
        <source>A distance of {grd:g} cm from a height of {height:g} m is finer than that of any camera on an aircraft; &apos;grd&apos; is in centimetres, so check whether it holds metres.</source>
        <translation>Zdolność {grd:g} cm z wysokości {height:g} m jest lepsza niż jakiejkolwiek kamery na samolocie; „grd” jest w centymetrach, sprawdź więc, czy nie zawiera metrów.</translation>
    </message>
    <message>
        <location filename="../plugin/resolution/measure/messages.py" line="91"/>
        <source>The interpolation edge_aware needs OpenCV (python3-opencv on Debian and Ubuntu, &apos;python -m pip install opencv-python-headless&apos; elsewhere); install it, or choose malvar or bilinear.</source>
        <translation>Interpolacja edge_aware wymaga biblioteki OpenCV (python3-opencv w systemach Debian i Ubuntu, w innych „python -m pip install opencv-python-headless”); zainstaluj ją albo wybierz malvar lub bilinear.</translation>
    </message>
    <message>
        <location filename="../plugin/resolution/measure/messages.py" line="94"/>
        <source>The interpolation edge_aware works on images of 8 or 16 bit and this one holds {kind}; choose malvar or bilinear.</source>
        <translation>Interpolacja edge_aware działa na obrazach 8- lub 16-bitowych, a ten zawiera {kind}; wybierz malvar lub bilinear.</translation>
    </message>
    <message>
        <location filename="../plugin/resolution/simulatebayer.py" line="38"/>
        <source>bilinear: the mean of the nearest pixels of the colour. malvar: sharper, as the recorded colour shows where the others change too (Malvar, He and Cutler 2004). edge_aware: along edges, by OpenCV, which has to be installed.</source>
        <translation>bilinear: średnia najbliższych pikseli danej barwy. malvar: ostrzej, bo barwa zarejestrowana w danym miejscu mówi, gdzie zmieniają się też pozostałe (Malvar, He i Cutler 2004). edge_aware: wzdłuż krawędzi, przez OpenCV, które musi być zainstalowane.</translation>
    </message>
    <message>
        <location filename="../plugin/resolution/measureresolution.py" line="52"/>
        <source>Reads the ground resolved distance from the image of a bar target, along and across the flight. Draw one line across the bars of each group. A group is resolved when all its bars stand out, and the amplitude of bars against gaps is at least half of the full one, that of bars against plain gaps, and exceeds three times the noise of the ground beside it. Bars finer than two pixels, and groups finer than one that is not resolved, are aliasing and are not counted (Walczykowski and others 2009).</source>
        <translation>Odczytuje terenową zdolność rozdzielczą (GRD) z obrazu testu paskowego, wzdłuż i w poprzek kierunku lotu. Narysuj jedną linię w poprzek pasków każdej grupy. Grupa jest rozróżniona, gdy widać wszystkie jej paski, a amplituda pasków względem przerw wynosi co najmniej połowę pełnej amplitudy, czyli amplitudy pasków względem jednolitych przerw, i przekracza trzykrotność szumu tła obok niej. Paski drobniejsze niż dwa piksele oraz grupy drobniejsze od nierozróżnionej to aliasing i nie są liczone (Walczykowski i in. 2009).</translation>
    </message>
    <message>
        <location filename="../plugin/resolution/measureresolution.py" line="64"/>
        <source>One line across the bars of each group, from the ground on one side to that on the other, with the fields &apos;group&apos; (whole number) and &apos;direction&apos; (&apos;along&apos; or &apos;across&apos; the flight). A line is turned by up to 10 degrees to be perpendicular to the bars. What observers saw may stand beside them, &apos;visible&apos; or &apos;invisible&apos;, in the fields &apos;observer&apos;, &apos;observer_2&apos; and so on.</source>
        <translation>Jedna linia w poprzek pasków każdej grupy, od tła po jednej stronie do tła po drugiej, z polami „group” (liczba całkowita) i „direction” („along” – wzdłuż albo „across” – w poprzek kierunku lotu). Linia jest obracana o najwyżej 10 stopni, aby była prostopadła do pasków. Obok może być zapisane, co widzieli obserwatorzy, „visible” lub „invisible”, w polach „observer”, „observer_2” i tak dalej.</translation>
    </message>
    <message>
        <location filename="../plugin/resolution/measureresolution.py" line="71"/>
        <source>How far on either side of the line the profile is averaged; less where the bars are shorter.</source>
        <translation>Jak daleko po obu stronach linii uśredniany jest profil; mniej, jeśli to więcej, niż wynosi długość pasków.</translation>
    </message>
    <message>
        <location filename="../plugin/resolution/measureresolution.py" line="83"/>
        <source>In centimetres on the ground; the next parameter says what it is the width of.</source>
        <translation>Dla grupy odniesienia, w centymetrach terenowych: szerokość tego, co podaje następny wiersz.</translation>
    </message>
    <message>
        <location filename="../plugin/resolution/measureresolution.py" line="85"/>
        <source>Distances are widths of</source>
        <translation>GRD to szerokość</translation>
    </message>
    <message>
        <location filename="../plugin/resolution/measureresolution.py" line="86"/>
        <source>cycle: a bar and a gap together, which is what resolution means. bar: one bar, as some targets and reports count. A bar and a gap finer than two pixels together are aliasing either way.</source>
        <translation>cycle: pasek i przerwa razem, co odpowiada definicji rozdzielczości. bar: jeden pasek, jak w niektórych testach i raportach. Pasek i przerwa razem drobniejsze niż dwa piksele to w każdym razie aliasing.</translation>
    </message>
    <message>
        <location filename="../plugin/resolution/measureresolution.py" line="97"/>
        <source>group: the group&apos;s own bars against plain gaps, as in the paper. coarsest: that of the coarsest group, a reference that doesn&apos;t change from group to group, and a stricter one.</source>
        <translation>group: własne paski grupy względem gładkich przerw, jak w artykule. coarsest: amplituda najgrubszej grupy – odniesienie, które nie zmienia się z grupy na grupę i jest surowsze.</translation>
    </message>
    <message>
        <location filename="../plugin/resolution/measureresolution.py" line="32"/>
        <source>Standard deviation along the flight (cm)</source>
        <translation>Odchylenie standardowe wzdłuż kierunku lotu (cm)</translation>
    </message>
    <message>
        <location filename="../plugin/resolution/measureresolution.py" line="33"/>
        <source>Standard deviation across the flight (cm)</source>
        <translation>Odchylenie standardowe w poprzek kierunku lotu (cm)</translation>
    </message>
    <message>
        <location filename="../plugin/resolution/measureresolution.py" line="34"/>
        <source>Standard deviation of the mean (cm)</source>
        <translation>Odchylenie standardowe średniej (cm)</translation>
    </message>
    <message>
        <location filename="../plugin/resolution/measureresolution.py" line="39"/>
        <source>Distance along the flight that all observers see (cm)</source>
        <translation>GRD wzdłuż kierunku lotu, którą widzą wszyscy obserwatorzy (cm)</translation>
    </message>
    <message>
        <location filename="../plugin/resolution/measureresolution.py" line="40"/>
        <source>Distance across the flight that all observers see (cm)</source>
        <translation>GRD w poprzek kierunku lotu, którą widzą wszyscy obserwatorzy (cm)</translation>
    </message>
    <message>
        <location filename="../plugin/resolution/measureresolution.py" line="41"/>
        <source>Contrast of the target, bars to gaps</source>
        <translation>Kontrast testu, paski do przerw</translation>
    </message>
    <message>
        <location filename="../plugin/resolution/minimumheight.py" line="102"/>
        <source>One row per pass with the fields &apos;height&apos; (metres above the target) and &apos;grd&apos; (centimetres), several observers&apos; in &apos;grd&apos;, &apos;grd_2&apos;, &apos;grd_3&apos; and so on: their heights are averaged within the pass. Rows that agree in &apos;sensor&apos;, &apos;image_type&apos; and &apos;direction&apos;, as far as there are such fields, make a group.</source>
        <translation>Jeden wiersz na przelot z polami „height” (metry nad testem) i „grd” (centymetry), a dla kilku obserwatorów „grd”, „grd_2”, „grd_3” i tak dalej: ich wysokości są uśredniane w ramach przelotu. Wiersze zgodne w polach „sensor”, „image_type” i „direction”, o ile takie pola istnieją, tworzą grupę.</translation>
    </message>
    <message>
        <location filename="../plugin/resolution/minimumheight.py" line="117"/>
        <source>One row per group: count, mean and spreads (metres), tolerance (%), and what to know about it.</source>
        <translation>Jeden wiersz na grupę: liczba, średnia i rozrzuty (metry), tolerancja (%) oraz uwagi.</translation>
    </message>
    <message>
        <location filename="../plugin/resolution/distance_words.py" line="48"/>
        <source>seen by all observers {direction}: {grd:.2f} cm</source>
        <translation>widoczne dla wszystkich obserwatorów {direction}: {grd:.2f} cm</translation>
    </message>
    <message>
        <location filename="../plugin/resolution/distance_words.py" line="52"/>
        <source>contrast of the target {contrast:.1f}:1</source>
        <translation>kontrast testu {contrast:.1f}:1</translation>
    </message>
    <message>
        <location filename="../plugin/resolution/charts.py" line="125"/>
        <source>group {group} {direction}</source>
        <translation>grupa {group} {direction}</translation>
    </message>
    <message>
        <location filename="../plugin/resolution/charts.py" line="126"/>
        <source>{grd:.2f} cm: {verdict}</source>
        <translation>{grd:.2f} cm: {verdict}</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/paper/inspection_record.py" line="83"/>
        <source>rules</source>
        <translation>reguły</translation>
    </message>
    <message>
        <location filename="../plugin/radiometry/words.py" line="27"/>
        <source>accepted</source>
        <translation>przyjęto</translation>
    </message>
    <message>
        <location filename="../plugin/radiometry/words.py" line="28"/>
        <source>rejected</source>
        <translation>odrzucono</translation>
    </message>
    <message>
        <location filename="../plugin/radiometry/words.py" line="29"/>
        <source>undecided</source>
        <translation>nie rozstrzygnięto</translation>
    </message>
    <message>
        <location filename="../plugin/radiometry/words.py" line="33"/>
        <source>each band</source>
        <translation>każdy kanał</translation>
    </message>
    <message>
        <location filename="../plugin/radiometry/words.py" line="34"/>
        <source>luminosity</source>
        <translation>jasność</translation>
    </message>
    <message>
        <location filename="../plugin/radiometry/words.py" line="96"/>
        <source>The largest step of tone is {step} in {band}, at {seam}, near {x:.2f}, {y:.2f}.</source>
        <translation>Największy skok tonalny wynosi {step}; kanał: {band}, miejsce: {seam}, w pobliżu {x:.2f}; {y:.2f}.</translation>
    </message>
    <message>
        <location filename="../plugin/radiometry/words.py" line="105"/>
        <source>Grey areas: {count}, with {pixels} px, {share:.2%} of the image; red, green and blue on them are {red:.1f}, {green:.1f}, {blue:.1f}. Area {area} has the most colour: {worst:.1%}, near {x:.2f}, {y:.2f}.</source>
        <translation>Szare obszary: {count}, piksele: {pixels}, {share:.2%} obrazu; czerwony, zielony i niebieski mają na nich {red:.1f}; {green:.1f}; {blue:.1f}. Najsilniejszą barwę ma obszar {area}: {worst:.1%}, w pobliżu {x:.2f}; {y:.2f}.</translation>
    </message>
    <message>
        <location filename="../plugin/radiometry/words.py" line="129"/>
        <source>Beyond their limits: {images}; by {checks}.</source>
        <translation>Poza granicami: {images}; reguły: {checks}.</translation>
    </message>
    <message>
        <location filename="../plugin/radiometry/words.py" line="132"/>
        <source>Required but not measurable: {checks}; in {images}.</source>
        <translation>Niemierzalne i wymagane: {checks}; obrazy: {images}.</translation>
    </message>
    <message>
        <location filename="../plugin/radiometry/words.py" line="136"/>
        <source>Not checked: {count}.</source>
        <translation>Nie sprawdzono: {count}.</translation>
    </message>
    <message>
        <location filename="../plugin/radiometry/words.py" line="140"/>
        <source>Not measurable and not required: {checks}; in {images}.</source>
        <translation>Niemierzalne i niewymagane: {checks}; obrazy: {images}.</translation>
    </message>
    <message>
        <location filename="../plugin/radiometry/words.py" line="143"/>
        <source>All figures are within their limits.</source>
        <translation>Wszystkie wartości mieszczą się w granicach.</translation>
    </message>
    <message>
        <location filename="../plugin/radiometry/words.py" line="150"/>
        <source>{names} and {count} more</source>
        <translation>{names} i jeszcze {count}</translation>
    </message>
    <message>
        <location filename="../plugin/radiometry/checkradiometry.py" line="46"/>
        <source>Checks images against the limits of a specification, by default JRC&apos;s for orthoimages in the LPIS: clipped tails, peak of the histogram and contrast of the luminosity, signal to noise on uniform mid-tone areas, colour balance on grey areas that you give, and with seamlines the step of tone at the seams. Whole rasters are streamed in blocks. What can&apos;t be measured is listed with the reason; nothing is accepted on a guess.</source>
        <translation>Sprawdza obrazy względem granic specyfikacji, domyślnie specyfikacji JRC dla ortoobrazów LPIS: obcięte krańce histogramu, położenie maksimum histogramu i kontrast jasności, stosunek sygnału do szumu na jednorodnych obszarach o średnich tonach, balans barw na podanych szarych obszarach, a przy podanych liniach mozaikowania także skok tonalny na nich. Całe rastry są czytane blokami. Czego nie można zmierzyć, jest podawane z przyczyną; nic nie jest przyjmowane na domysł.</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/acceptmosaic.py" line="63"/>
        <source>Ready rules</source>
        <translation>Gotowe reguły</translation>
    </message>
    <message>
        <location filename="../plugin/radiometry/checkradiometry.py" line="65"/>
        <source>jrc_lpis: as JRC&apos;s text says, clipping, peak and contrast of the luminosity. jrc_lpis_each_band: stricter, each band is held to the limits, and signal to noise and colour balance have to be known.</source>
        <translation>jrc_lpis: jak mówi tekst JRC, obcięcie, maksimum i kontrast histogramu jasności. jrc_lpis_each_band: surowiej, granice obowiązują każdy kanał, a stosunek sygnału do szumu i balans barw muszą być znane.</translation>
    </message>
    <message>
        <location filename="../plugin/radiometry/checkradiometry.py" line="69"/>
        <source>A JSON file of your own with the limits and where they come from, instead of the ready rules; the documentation has one to start from.</source>
        <translation>Własny plik JSON z granicami i ich pochodzeniem, zamiast gotowych reguł; dokumentacja zawiera plik wyjściowy.</translation>
    </message>
    <message>
        <location filename="../plugin/radiometry/checkradiometry.py" line="73"/>
        <source>Range of values</source>
        <translation>Zakres wartości</translation>
    </message>
    <message>
        <location filename="../plugin/radiometry/checkradiometry.py" line="74"/>
        <source>The lowest and highest value that pixels can have, such as 0 to 4095 for 12 bits in 16. Needed where neither the file (NBITS) nor all files together show it: without it nothing that depends on it is judged.</source>
        <translation>Najniższa i najwyższa wartość, jaką mogą mieć piksele, np. od 0 do 4095 dla 12 bitów w 16. Potrzebne, gdy nie podaje tego ani plik (NBITS), ani wszystkie pliki razem: wtedy nic, co od tego zależy, nie jest oceniane.</translation>
    </message>
    <message>
        <location filename="../plugin/radiometry/checkradiometry.py" line="77"/>
        <source>Grey areas</source>
        <translation>Szare obszary</translation>
    </message>
    <message>
        <location filename="../plugin/radiometry/checkradiometry.py" line="78"/>
        <source>Polygons on surfaces that are grey: roads, roofs, concrete. The colour balance is measured on them; without them it is not measurable, since a cast looks the same as the colour of the ground.</source>
        <translation>Poligony na powierzchniach, które są szare: drogi, dachy, beton. Mierzony jest na nich balans barw; bez nich nie można go zmierzyć, ponieważ żaden piksel nie odróżnia dominanty barwnej od barwy terenu.</translation>
    </message>
    <message>
        <location filename="../plugin/radiometry/checkradiometry.py" line="89"/>
        <source>What may be grey</source>
        <translation>Obszary, które mogą być szare</translation>
    </message>
    <message>
        <location filename="../plugin/radiometry/checkradiometry.py" line="91"/>
        <source>Uniform areas with little colour, where no grey areas are given: look at them, delete what is not grey, and give the others as grey areas.</source>
        <translation>Jednorodne obszary o słabej barwie, gdy nie podano obszarów szarych: obejrzyj je, usuń to, co nie jest szare, a pozostałe podaj jako obszary szare.</translation>
    </message>
    <message>
        <location filename="../plugin/radiometry/checkradiometry.py" line="95"/>
        <source>The decision and all figures with the histograms on one HTML page.</source>
        <translation>Decyzja i wszystkie wartości z histogramami na jednej stronie HTML.</translation>
    </message>
    <message>
        <location filename="../plugin/radiometry/checkradiometry.py" line="96"/>
        <source>Decision: accepted, rejected or undecided</source>
        <translation>Decyzja: przyjęte, odrzucone lub nierozstrzygnięte</translation>
    </message>
    <message>
        <location filename="../plugin/radiometry/checkradiometry.py" line="97"/>
        <source>Reasons of the decision</source>
        <translation>Uzasadnienie decyzji</translation>
    </message>
    <message>
        <location filename="../plugin/radiometry/measure/messages.py" line="7"/>
        <source>{place} in {name}: &apos;{check}&apos; of {band} already has a rule; keep one.</source>
        <translation>{place} w pliku {name}: „{check}” dla {band} ma już regułę; zostaw jedną.</translation>
    </message>
    <message>
        <location filename="../plugin/radiometry/measure/messages.py" line="9"/>
        <source>{place} in {name}: &apos;{check}&apos; compares red, green and blue, so it has no &apos;band&apos;.</source>
        <translation>{place} w pliku {name}: „{check}” jest liczone między czerwonym, zielonym i niebieskim i nie ma „band”.</translation>
    </message>
    <message>
        <location filename="../plugin/radiometry/measure/messages.py" line="11"/>
        <source>{place} in {name}: &apos;band&apos; has to be luminosity, each, or the name of a band such as red, nir or band_4.</source>
        <translation>{place} w pliku {name}: „band” musi mieć wartość luminosity, each albo nazwę kanału, np. red, nir lub band_4.</translation>
    </message>
    <message>
        <location filename="../plugin/radiometry/measure/messages.py" line="12"/>
        <source>{place} in {name}: &apos;value_range&apos; has to be two numbers, the smaller one first.</source>
        <translation>{place} w pliku {name}: „value_range” muszą tworzyć dwie liczby, najpierw mniejsza.</translation>
    </message>
    <message>
        <location filename="../plugin/radiometry/measure/messages.py" line="20"/>
        <source>values of type {data_type} have no fixed range; give the range of values, or &apos;value_range&apos; in the rules file.</source>
        <translation>wartości typu {data_type} nie mają własnego zakresu; podaj zakres wartości albo „value_range” w pliku reguł.</translation>
    </message>
    <message>
        <location filename="../plugin/radiometry/measure/messages.py" line="23"/>
        <source>the files do not say how many bits their values have. The largest value of all such images ({count}) is {largest}, so {possible} bits are possible. Give the range of values, as 0 to 4095 for 12 bits, or &apos;value_range&apos; in the rules file.</source>
        <translation>pliki nie podają, ile bitów mają ich wartości. Największa wartość wszystkich takich obrazów ({count}) wynosi {largest}, więc możliwa liczba bitów to {possible}. Podaj zakres wartości, np. od 0 do 4095 dla 12 bitów, albo „value_range” w pliku reguł.</translation>
    </message>
    <message>
        <location filename="../plugin/radiometry/measure/messages.py" line="27"/>
        <source>the file says that its values have {bits} bits, but holds values up to {largest}; give the range of values, or &apos;value_range&apos; in the rules file.</source>
        <translation>według pliku liczba bitów jego wartości to {bits}, a zawiera on wartości do {largest}; podaj zakres wartości albo „value_range” w pliku reguł.</translation>
    </message>
    <message>
        <location filename="../plugin/radiometry/measure/messages.py" line="35"/>
        <source>no grey areas are given, and none that may be grey were found; draw roads or roofs and give them as grey areas.</source>
        <translation>nie podano obszarów szarych i nie znaleziono takich, które mogą być szare; narysuj drogi lub dachy i podaj je jako obszary szare.</translation>
    </message>
    <message>
        <location filename="../plugin/radiometry/measure/messages.py" line="38"/>
        <source>no grey areas are given. {count} areas of 16 px that may be grey were found ({share:.1%} of those looked at, near {x:.1f}, {y:.1f}); their red, green and blue differ by {difference:.1%}, which may be a cast or the colour of the ground. Look at them and give those that are grey.</source>
        <translation>nie podano obszarów szarych. Znaleziono obszary 16 px, które mogą być szare: {count} ({share:.1%} obejrzanych, w pobliżu {x:.1f}; {y:.1f}); ich kanały czerwony, zielony i niebieski różnią się o {difference:.1%}, co może powodować zarówno dominanta barwna, jak i barwa terenu. Obejrzyj je i podaj te, które są szare.</translation>
    </message>
    <message>
        <location filename="../plugin/radiometry/measure/messages.py" line="42"/>
        <source>the grey areas show fewer than {least} valid pixels of it that are neither too dark nor too bright; draw more.</source>
        <translation>w obszarach szarych jest mniej niż {least} jego pikseli z danymi, które nie są ani zbyt ciemne, ani zbyt jasne; narysuj więcej obszarów.</translation>
    </message>
    <message>
        <location filename="../plugin/radiometry/measure/messages.py" line="45"/>
        <source>it has no red, green and blue to mix; name one of its bands in the rules.</source>
        <translation>nie ma czerwonego, zielonego i niebieskiego do zmieszania; podaj w regułach nazwę jednego z jego kanałów.</translation>
    </message>
    <message>
        <location filename="../plugin/radiometry/measure/messages.py" line="46"/>
        <source>it has no band {band}.</source>
        <translation>nie ma kanału {band}.</translation>
    </message>
    <message>
        <location filename="../plugin/radiometry/measure/messages.py" line="50"/>
        <source>{name}: what depends on the range of values is not judged: {why}</source>
        <translation>{name}: to, co zależy od zakresu wartości, nie jest oceniane: {why}</translation>
    </message>
    <message>
        <location filename="../plugin/radiometry/measure/messages.py" line="52"/>
        <source>{name}: {share:.2%} of the pixels lie beyond the range of {low:g} to {high:g} that was given, and count as clipped; check the range.</source>
        <translation>{name}: {share:.2%} pikseli leży poza podanym zakresem od {low:g} do {high:g} i liczy się jako obcięte; sprawdź zakres.</translation>
    </message>
    <message>
        <location filename="../plugin/radiometry/measure/messages.py" line="57"/>
        <source>seam {number}</source>
        <translation>linia mozaikowania {number}</translation>
    </message>
    <message>
        <location filename="../plugin/radiometry/measure/messages.py" line="58"/>
        <source>seam {number} (feature {features} of {layer})</source>
        <translation>linia mozaikowania {number} (obiekt {features} warstwy {layer})</translation>
    </message>
    <message>
        <location filename="../plugin/radiometry/measure/messages.py" line="59"/>
        <source>grey area {area} with {share:.1%}, the most of all</source>
        <translation>obszar szary {area}: {share:.1%}, najwięcej ze wszystkich</translation>
    </message>
    <message>
        <location filename="../plugin/seams/report/inspection_report.py" line="114"/>
        <source>least share kept along the seam</source>
        <translation>najmniejsza część zachowana wzdłuż linii mozaikowania</translation>
    </message>
    <message>
        <location filename="../plugin/seams/report/inspection_report.py" line="115"/>
        <source>limit of the paper&apos;s rule, ratio 1</source>
        <translation>granica według reguły z artykułu, stosunek 1</translation>
    </message>
    <message>
        <location filename="../plugin/seams/report/inspection_report.py" line="119"/>
        <source>orthoimage</source>
        <translation>ortoobraz</translation>
    </message>
    <message>
        <location filename="../plugin/seams/algorithms/report.py" line="35"/>
        <source>Writes one HTML page that opens anywhere without network and prints well on A4: a summary by mosaic, a map sketch of the windows by verdict, their relative variances as in table 1 of Pyka 2010, and for each flagged window (a significant loss, or one that the observer saw) what it keeps by distance from the seam, where it lost detail, its curves, its clips at 2x, cause and observer.</source>
        <translation>Zapisuje jedną stronę HTML, która otwiera się wszędzie bez sieci i dobrze drukuje się na A4: podsumowanie według ortofotomap, szkic mapy z oknami według ocen, ich wariancje względne jak w tabeli 1 pracy Pyka 2010, a dla każdego oznaczonego okna (strata istotna lub zauważona przez obserwatora) to, co zachowuje ono w zależności od odległości od linii mozaikowania, miejsce straty detali, krzywe, wycinki 2×, przyczynę i obserwatora.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/algorithms/report.py" line="52"/>
        <source>The table of seam profiles of the same windows: how much detail is kept by distance from the seam.</source>
        <translation>Tabela profili linii mozaikowania tych samych okien: ile detali zachowano w zależności od odległości od linii.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/algorithms/report.py" line="64"/>
        <source>The limit drawn in the seam profiles: the one the windows were inspected with.</source>
        <translation>Granica rysowana na profilach linii mozaikowania: ta, z którą skontrolowano okna.</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/stated_rules.py" line="88"/>
        <source>stated for this decision ({parameter})</source>
        <translation>określone dla tej decyzji ({parameter})</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/measure/messages.py" line="226"/>
        <source>The folder {folder} can&apos;t be written ({error}), so the layer of failures has no pictures.</source>
        <translation>Nie można zapisać katalogu {folder} ({error}), więc warstwa usterek nie ma obrazów.</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/measure/messages.py" line="228"/>
        <source>Failures without a picture: {count}; the mosaic does not show them, or can&apos;t be read there.</source>
        <translation>Usterki bez obrazu: {count}; ortofotomapa ich nie pokazuje albo nie można jej tam odczytać.</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/paper/paper_head.py" line="53"/>
        <source>The mosaic or its sheets: pictures of the failures are cut from them, for the layer and the report.</source>
        <translation>Ortofotomapa lub jej arkusze: wycinane są z nich obrazy usterek do warstwy i raportu.</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/paper/outputs.py" line="93"/>
        <source>Failures</source>
        <translation>Usterki</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/paper/paper_head.py" line="61"/>
        <source>One feature for each failure without a break, for the producer: place, length, what is kept, the two orthoimages and their dates, remarks, and a picture in a folder beside the file. GeoPackage or CSV.</source>
        <translation>Jeden obiekt na każdą nieprzerwaną usterkę, dla wykonawcy: miejsce, długość, ile zachowano, oba ortoobrazy i ich daty, uwagi oraz obraz w katalogu obok pliku. GeoPackage lub CSV.</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/paper/paper_head.py" line="73"/>
        <source>Quality record (ISO 19157)</source>
        <translation>Zapis jakości (ISO 19157)</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/paper/paper_head.py" line="74"/>
        <source>The figures and the decision for a metadata catalogue: ISO 19157:2013 in the XML of ISO/TS 19157-2:2016.</source>
        <translation>Wartości i decyzja w postaci, którą odczyta katalog: ISO 19157:2013 w XML według ISO/TS 19157-2:2016.</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/paper/words.py" line="39"/>
        <source>least detail kept</source>
        <translation>najmniejsza zachowana część detali</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/paper/words.py" line="28"/>
        <source>share of the seams that failed</source>
        <translation>niezgodna część linii mozaikowania</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/paper/words.py" line="33"/>
        <source>longest failure without a break</source>
        <translation>najdłuższa nieprzerwana usterka</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/paper/words.py" line="48"/>
        <source>share of the seams that was measured</source>
        <translation>zmierzona część linii mozaikowania</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/paper/words.py" line="44"/>
        <source>failed pieces in the sample</source>
        <translation>niezgodne odcinki w próbie</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/paper/words.py" line="93"/>
        <source>A piece of seam fails where it keeps less than {least} of the detail.</source>
        <translation>Odcinek jest niezgodny tam, gdzie zachowuje mniej niż {least} detali.</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/paper/inspection_record.py" line="78"/>
        <source>density</source>
        <translation>gęstość</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/paper/inspection_record.py" line="79"/>
        <source>length of a piece of seam (m)</source>
        <translation>długość odcinka linii mozaikowania (m)</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/paper/inspection_record.py" line="79"/>
        <source>corridor (m)</source>
        <translation>korytarz (m)</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/paper/inspection_record.py" line="84"/>
        <source>file of the rules</source>
        <translation>plik reguł</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/paper/inspection_record.py" line="85"/>
        <source>which pieces fail</source>
        <translation>które odcinki są niezgodne</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/paper/inspection_record.py" line="88"/>
        <source>layer of windows</source>
        <translation>warstwa okien</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/paper/inspection_record.py" line="89"/>
        <source>reference system</source>
        <translation>układ współrzędnych</translation>
    </message>
    <message>
        <source>of it failed</source>
        <translation>z tego niezgodne</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/paper/acceptance_report.py" line="223"/>
        <source>says which pieces fail</source>
        <translation>określa, które odcinki są niezgodne</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/paper/acceptance_report.py" line="222"/>
        <source>at least {least} in each piece</source>
        <translation>co najmniej {least} w każdym odcinku</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/paper/acceptance_report.py" line="254"/>
        <source>pieces that failed</source>
        <translation>odcinki niezgodne</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/paper/acceptance_report.py" line="254"/>
        <source>pieces that passed</source>
        <translation>odcinki zgodne</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/paper/quality_document.py" line="80"/>
        <source>acceptance of the delivery</source>
        <translation>odbiór dostawy</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/paper/quality_document.py" line="80"/>
        <source>Whether the delivery meets the rules.</source>
        <translation>Czy dostawa spełnia reguły.</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/paper/quality_document.py" line="81"/>
        <source>All rules together: the delivery is accepted if none of them fails.</source>
        <translation>Wszystkie reguły łącznie: dostawa jest przyjęta, gdy wszystkie są spełnione.</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/paper/quality_document.py" line="115"/>
        <source>Each piece of seam: the finest detail that is left in the strip along it, relative to the ground around it (wavelet decomposition).</source>
        <translation>Każdy odcinek linii mozaikowania: najdrobniejsze detale, które pozostały w pasie wzdłuż niego, względem otoczenia (dekompozycja falkowa).</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/paper/words.py" line="29"/>
        <source>Length of the pieces of seam that failed, divided by the measured length.</source>
        <translation>Długość niezgodnych odcinków względem długości zmierzonej.</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/paper/words.py" line="34"/>
        <source>Length of the longest row of failed pieces that follow each other without a break, across sheets too.</source>
        <translation>Długość najdłuższego nieprzerwanego ciągu niezgodnych odcinków, także przez granice arkuszy.</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/paper/words.py" line="40"/>
        <source>Share of the finest detail of the orthoimages that is left in the piece of seam that kept least.</source>
        <translation>Część najdrobniejszych detali ortoobrazów, która pozostała w odcinku linii mozaikowania o najmniejszym zachowaniu.</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/paper/quality_document.py" line="108"/>
        <source>{count} pieces of seam of {sheets} sheets</source>
        <translation>{count} {count:odcinek|odcinki|odcinków} linii mozaikowania z {sheets} {sheets:arkusza|arkuszy|arkuszy}</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/paper/quality_document.py" line="113"/>
        <source>Each piece of seam of the sample.</source>
        <translation>Każdy odcinek linii mozaikowania z próby.</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/paper/words.py" line="44"/>
        <source>Pieces of seam in the sample that failed.</source>
        <translation>Niezgodne odcinki w próbie.</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/paper/quality_document.py" line="105"/>
        <source>From the results of all pieces of seam.</source>
        <translation>Z wyników wszystkich odcinków linii mozaikowania.</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/checkdelivery.py" line="47"/>
        <source>Sheets</source>
        <translation>Arkusze</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/sheet_index.py" line="34"/>
        <source>Outlines of the sheets if all were scanned as one mosaic: an index as gdaltindex writes it, or polygons with a field sheet or name. Empty: each layer of seams is a sheet, unless its field sheet says otherwise.</source>
        <translation>Obrysy arkuszy, gdy wszystkie zbadano jako jedną ortofotomapę: skorowidz w postaci, którą zapisuje gdaltindex, albo poligony z polem sheet lub name. Puste pole: arkuszem jest każda warstwa linii mozaikowania albo to, co podaje jej pole sheet.</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/measure/messages.py" line="7"/>
        <source>The layer of sheets does not name them; it needs one of the fields {fields}.</source>
        <translation>Warstwa arkuszy nie podaje ich nazw; potrzebuje jednego z pól {fields}.</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/measure/messages.py" line="9"/>
        <source>No piece of seam lies in any of the sheets; choose the index of this delivery, and check its reference system.</source>
        <translation>W żadnym arkuszu nie leży ani jeden odcinek linii mozaikowania; wybierz skorowidz tej dostawy i sprawdź jego układ współrzędnych.</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/measure/messages.py" line="17"/>
        <source>{name} has two rules for &apos;{check}&apos; ({place} is the second); keep one.</source>
        <translation>Plik {name} zawiera dwie reguły dla „{check}” ({place} to druga); zostaw jedną.</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/measure/messages.py" line="18"/>
        <source>{name} does not say what a piece must keep; add a rule with the check &apos;kept&apos;.</source>
        <translation>W pliku {name} nie ma nic o tym, ile odcinek musi zachować; dodaj regułę z kontrolą „kept”.</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/measure/messages.py" line="21"/>
        <source>{name} has no rule to decide by; add a rule &apos;failed_share&apos;, &apos;longest_failure&apos; or &apos;sampling&apos;.</source>
        <translation>W pliku {name} nie ma niczego, według czego można zdecydować; dodaj regułę „failed_share”, „longest_failure” lub „sampling”.</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/measure/messages.py" line="22"/>
        <source>{place} in {name}: the check &apos;{check}&apos; needs &apos;{key}&apos;; give it.</source>
        <translation>{place} w pliku {name}: kontrola „{check}” wymaga „{key}”; podaj tę wartość.</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/measure/messages.py" line="23"/>
        <source>{place} in {name}: &apos;{key}&apos; is {limit:g} and a share is at most 1; write 2 % as 0.02.</source>
        <translation>{place} w pliku {name}: „{key}” wynosi {limit:g}, a część to najwyżej 1; zapisz 2 % jako 0.02.</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/measure/messages.py" line="27"/>
        <source>Both the ready rules &apos;{ready}&apos; and the rules in {name} are given; choose one of them.</source>
        <translation>Podano gotowe reguły „{ready}” i reguły z pliku {name}; zostaw jedne z nich.</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/measure/messages.py" line="29"/>
        <source>The lot has {size} items and a plan of sampling needs at least 2; inspect all of it instead.</source>
        <translation>Liczność partii wynosi {size}, a plan kontroli wymaga co najmniej 2; skontroluj całą partię.</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/measure/messages.py" line="31"/>
        <source>The lot size is {size} and the layers hold {given} pieces; give the size of the whole lot, or 0 to take what is given.</source>
        <translation>Liczność partii wynosi {size}, a liczba odcinków w warstwach {given}; podaj liczność całej partii albo 0, aby wziąć to, co podano.</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/measure/messages.py" line="33"/>
        <source>Windows are placed on the mosaic&apos;s pixels; give MOSAIC, or take pieces as the unit.</source>
        <translation>Okna są rozmieszczane na pikselach ortofotomapy; podaj MOSAIC albo wybierz odcinki jako jednostkę.</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/measure/messages.py" line="35"/>
        <source>The mosaic is smaller than a window of {pixels} px, the power of two that spans {side:g} m; give a shorter SIDE.</source>
        <translation>Ortofotomapa jest mniejsza niż okno o boku {pixels} px, potędze dwójki, która obejmuje {side:g} m; podaj krótszy bok (SIDE).</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/measure/messages.py" line="37"/>
        <source>A window of {side:g} m has {pixels} px and needs {least} at least; give a longer SIDE.</source>
        <translation>Okno o boku {side:g} m ma {pixels} px, a potrzeba co najmniej {least}; podaj dłuższy bok (SIDE).</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/measure/messages.py" line="42"/>
        <source>The plan needs {size} pieces and the layers hold {drawn}; draw the others from the rest of the lot.</source>
        <translation>Plan wymaga odcinków w liczbie {size}, a warstwy zawierają {drawn}; wylosuj pozostałe z reszty partii.</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/measure/messages.py" line="49"/>
        <source>{why}; {also}</source>
        <translation>{why}; {also}</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/measure/messages.py" line="61"/>
        <source>{value:.2%} of the measured metres failed, {limit:.2%} is allowed</source>
        <translation>niezgodne jest {value:.2%} zmierzonych metrów, a dopuszcza się {limit:.2%}</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/measure/messages.py" line="79"/>
        <source>nothing was measured, so it can&apos;t be decided</source>
        <translation>niczego nie zmierzono, więc nie da się tego określić</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/measure/messages.py" line="128"/>
        <source>the plan needs a sample of {needed} pieces and {given} were measured, so it can&apos;t be decided</source>
        <translation>plan wymaga próby o liczności {needed}, a odcinków zmierzono {given}, więc nie da się tego określić</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/measure/messages.py" line="199"/>
        <source>The sample of {size} was drawn of {given} measured pieces with the seed {seed}.</source>
        <translation>Próbę o liczności {size} wylosowano ze zmierzonych odcinków w liczbie {given}, z ziarnem losowania {seed}.</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/measure/messages.py" line="201"/>
        <source>The layers are a sample of {given} pieces of seam: metres and shares are those of the sample, and the longest failure of the delivery can&apos;t be determined from it.</source>
        <translation>Warstwy są próbą odcinków ({given}): metry i udziały dotyczą próby, a z niej nie da się powiedzieć, jak długa jest najdłuższa usterka dostawy.</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/measure/messages.py" line="203"/>
        <source>the longest failure can&apos;t be determined from a sample</source>
        <translation>z próby nie da się powiedzieć, jak długa jest najdłuższa usterka</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/measure/messages.py" line="209"/>
        <source>No layer of seams is given; choose the layers &apos;Seams&apos; of one or more scans.</source>
        <translation>Nie podano warstwy linii mozaikowania; wybierz warstwy „Odcinki linii mozaikowania” z jednego lub wielu badań.</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/measure/messages.py" line="211"/>
        <source>{name} has no field &apos;kept_1&apos;; choose the layer &apos;Seams&apos; of a scan, not the seamlines.</source>
        <translation>{name}: brak pola „kept_1”; wybierz warstwę „Odcinki linii mozaikowania” z badania, a nie linie mozaikowania.</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/measure/messages.py" line="212"/>
        <source>{name} is empty: no seam of it can be judged.</source>
        <translation>{name}: warstwa jest pusta, więc nie ma linii mozaikowania do oceny.</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/measure/messages.py" line="216"/>
        <source>{name}: features without a line are left out ({count}).</source>
        <translation>{name}: pominięte obiekty bez linii: {count}.</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/measure/messages.py" line="218"/>
        <source>{count} pieces of seam are given twice, the same line with the same figures; they count once.</source>
        <translation>Odcinki podane dwa razy (ta sama linia, to samo zachowanie detali): {count}; liczą się raz.</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/measure/messages.py" line="221"/>
        <source>{name} can&apos;t be transformed to the reference system of the first layer; check the systems of both.</source>
        <translation>{name}: nie można przeliczyć do układu współrzędnych pierwszej warstwy; sprawdź układy obu warstw.</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/measure/messages.py" line="222"/>
        <source>{parameter} is {value:g} and has to lie between {least:g} and {most:g}.</source>
        <translation>{parameter} wynosi {value:g}, a musi leżeć między {least:g} a {most:g}.</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/acceptmosaic.py" line="40"/>
        <source>Accept or reject a delivery</source>
        <translation>Przyjmij lub odrzuć dostawę</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/acceptmosaic.py" line="51"/>
        <source>The layers &apos;Seams&apos; of the scans of one delivery, a sheet each, or a sample that &apos;Plan an inspection&apos; drew of them.</source>
        <translation>Warstwy „Odcinki linii mozaikowania” z badań jednej dostawy, po jednej na arkusz, albo próba wylosowana z nich przez algorytm „Zaplanuj kontrolę”.</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/acceptmosaic.py" line="56"/>
        <source>Plan</source>
        <translation>Plan</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/acceptmosaic.py" line="64"/>
        <source>Rules that come with the plugin, instead of the limits above; leave those at their defaults.</source>
        <translation>Reguły dostarczane z wtyczką, zamiast powyższych granic, które wtedy pozostają bez zmian.</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/acceptmosaic.py" line="67"/>
        <source>A JSON file of your own with limits and where they come from, instead of the limits above; leave those at their defaults. The documentation has an example.</source>
        <translation>Własny plik JSON z granicami i ich pochodzeniem, zamiast powyższych granic, które wtedy pozostają bez zmian. Przykład jest w dokumentacji.</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/acceptmosaic.py" line="79"/>
        <source>Length that was measured (metres)</source>
        <translation>Długość zmierzona (metry)</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/acceptmosaic.py" line="80"/>
        <source>Length that failed (metres)</source>
        <translation>Długość niezgodna (metry)</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/acceptmosaic.py" line="81"/>
        <source>Share of the measured length that failed (%)</source>
        <translation>Udział niezgodnych w zmierzonej długości (%)</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/acceptmosaic.py" line="82"/>
        <source>Longest failure without a break (metres)</source>
        <translation>Najdłuższa nieprzerwana usterka (metry)</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/acceptmosaic.py" line="150"/>
        <source>Least share of detail kept</source>
        <translation>Najmniejsza zachowana część detali</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/acceptmosaic.py" line="151"/>
        <source>A piece of seam fails when its kept_1 is smaller; one that keeps exactly as much passes.</source>
        <translation>Odcinek linii mozaikowania jest niezgodny, gdy jego kept_1 jest mniejsze; odcinek, który zachowuje dokładnie tyle, jest zgodny.</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/acceptmosaic.py" line="152"/>
        <source>Largest share that may fail (%)</source>
        <translation>Największy udział niezgodnych (%)</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/acceptmosaic.py" line="152"/>
        <source>Share of the measured metres of seam.</source>
        <translation>Odniesiony do zmierzonych metrów linii mozaikowania.</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/acceptmosaic.py" line="154"/>
        <source>Failed pieces that follow each other, across seams and sheets where they touch.</source>
        <translation>Niezgodne odcinki, które następują po sobie, także na kolejnych liniach mozaikowania i arkuszach, jeśli się stykają.</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/acceptmosaic.py" line="155"/>
        <source>Least share that has to be measured (%)</source>
        <translation>Najmniejszy udział, który musi być zmierzony (%)</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/planinspection.py" line="31"/>
        <source>Plan an inspection</source>
        <translation>Zaplanuj kontrolę</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/planinspection.py" line="48"/>
        <source>How many are drawn with the plan &apos;count&apos;.</source>
        <translation>Ile odcinków jest losowanych przy planie „count”.</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/planinspection.py" line="49"/>
        <source>Unit</source>
        <translation>Jednostka</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/planinspection.py" line="50"/>
        <source>pieces: pieces of seam, as lines. windows: one around the middle of each, on the mosaic&apos;s pixels.</source>
        <translation>pieces: odcinki linii mozaikowania jako linie. windows: po jednym oknie wokół środka każdego odcinka, na pikselach ortofotomapy.</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/planinspection.py" line="58"/>
        <source>Sample</source>
        <translation>Próba</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/planinspection.py" line="59"/>
        <source>The sample: its field &apos;sample&apos; numbers the pieces as they were drawn, &apos;lot_size&apos; is how many there were.</source>
        <translation>Próba: jej pole „sample” numeruje odcinki w kolejności losowania, a „lot_size” podaje, z ilu.</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/planinspection.py" line="62"/>
        <source>Pieces in the sample</source>
        <translation>Odcinki w próbie</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/planinspection.py" line="63"/>
        <source>How many of them may fail</source>
        <translation>Ile z nich może być niezgodnych</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/planinspection.py" line="64"/>
        <source>Pieces in the lot</source>
        <translation>Odcinki w partii</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/planinspection.py" line="66"/>
        <source>Code letter of the plan</source>
        <translation>Znak literowy planu</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/planned_sample.py" line="116"/>
        <source>Sample (windows)</source>
        <translation>Próba (okna)</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/planned_sample.py" line="116"/>
        <source>Sample (pieces)</source>
        <translation>Próba (odcinki)</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/stated_rules.py" line="108"/>
        <source>Lot size</source>
        <translation>Liczność partii</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/stated_rules.py" line="109"/>
        <source>How many pieces of seam the whole lot has; 0: as many as the layers hold.</source>
        <translation>Ile odcinków linii mozaikowania ma cała partia; 0: tyle, ile zawierają warstwy.</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/stated_rules.py" line="112"/>
        <source>Acceptance quality limit (AQL)</source>
        <translation>Akceptowany poziom jakości (AQL)</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/stated_rules.py" line="120"/>
        <source>Inspection level</source>
        <translation>Poziom kontroli</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/stated_rules.py" line="121"/>
        <source>How large the sample is for its lot: II unless something else was agreed; S-1 is the smallest.</source>
        <translation>Jak duża jest próba w stosunku do partii: II, jeśli nie uzgodniono inaczej; S-1 daje próbę najmniejszą.</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/stated_rules.py" line="124"/>
        <source>Starts the random draw: the same seed draws the same sample again.</source>
        <translation>To samo ziarno losuje ponownie tę samą próbę.</translation>
    </message>
    <message>
        <location filename="../plugin/photos/report.py" line="37"/>
        <source>photo</source>
        <translation>zdjęcie</translation>
    </message>
    <message>
        <location filename="../plugin/photos/report.py" line="51"/>
        <source>marks measured</source>
        <translation>znaczki zmierzone</translation>
    </message>
    <message>
        <location filename="../plugin/photos/report.py" line="51"/>
        <source>marks given</source>
        <translation>znaczki podane</translation>
    </message>
    <message>
        <location filename="../plugin/photos/report.py" line="51"/>
        <source>marks failed</source>
        <translation>znaczki odrzucone</translation>
    </message>
    <message>
        <location filename="../plugin/photos/report.py" line="55"/>
        <source>root mean square of the residuals</source>
        <translation>średnia kwadratowa odchyłek</translation>
    </message>
    <message>
        <location filename="../plugin/photos/report.py" line="88"/>
        <source>pixel size</source>
        <translation>wielkość piksela</translation>
    </message>
    <message>
        <location filename="../plugin/photos/report.py" line="89"/>
        <source>rotation</source>
        <translation>obrót</translation>
    </message>
    <message>
        <location filename="../plugin/photos/report.py" line="90"/>
        <source>shear</source>
        <translation>nieortogonalność osi</translation>
    </message>
    <message>
        <location filename="../plugin/photos/report.py" line="91"/>
        <source>principal point</source>
        <translation>punkt główny</translation>
    </message>
    <message>
        <location filename="../plugin/photos/report.py" line="95"/>
        <source>focal length</source>
        <translation>ogniskowa</translation>
    </message>
    <message>
        <location filename="../plugin/photos/report.py" line="101"/>
        <source>calibration</source>
        <translation>kalibracja</translation>
    </message>
    <message>
        <location filename="../plugin/photos/report.py" line="104"/>
        <source>marks drawn as</source>
        <translation>znaczki narysowane jako</translation>
    </message>
    <message>
        <location filename="../plugin/photos/report.py" line="107"/>
        <source>template</source>
        <translation>wzorzec</translation>
    </message>
    <message>
        <location filename="../plugin/photos/report.py" line="111"/>
        <source>smallest correlation</source>
        <translation>najmniejsza korelacja</translation>
    </message>
    <message>
        <location filename="../plugin/photos/report.py" line="112"/>
        <source>search</source>
        <translation>zasięg szukania</translation>
    </message>
    <message>
        <location filename="../plugin/photos/report.py" line="113"/>
        <source>surface</source>
        <translation>powierzchnia</translation>
    </message>
    <message>
        <location filename="../plugin/photos/report.py" line="114"/>
        <source>largest distance of a mark from its place</source>
        <translation>największe dopuszczalne odchylenie znaczka</translation>
    </message>
    <message>
        <location filename="../plugin/photos/report.py" line="123"/>
        <source>failed; it should be here</source>
        <translation>odrzucony; powinien być tutaj</translation>
    </message>
    <message>
        <location filename="../plugin/photos/measure/messages.py" line="62"/>
        <source>The mark &apos;{mark}&apos; stands out: the others, which agree well, place it {worst:.2f} mm away; look at its picture.</source>
        <translation>Znaczek „{mark}” odstaje: pozostałe, które są ze sobą zgodne, wskazują miejsce odległe o {worst:.2f} mm; obejrzyj jego obraz.</translation>
    </message>
    <message>
        <location filename="../plugin/photos/measure/messages.py" line="65"/>
        <source>No mark of {name} can be trusted ({why}); check the positions, their names and the calibration.</source>
        <translation>Żadnemu znaczkowi z {name} nie można ufać ({why}); sprawdź położenia, nazwy znaczków i kalibrację.</translation>
    </message>
    <message>
        <location filename="../plugin/photos/measure/messages.py" line="86"/>
        <source>the given place lies {worst:.2f} mm from where the other marks place it and {limit:.2f} mm is allowed; check it and its name</source>
        <translation>podane miejsce leży {worst:.2f} mm od tego, na które wskazują pozostałe znaczki, a dopuszczalne jest {limit:.2f} mm; sprawdź je i jego nazwę</translation>
    </message>
    <message>
        <location filename="../plugin/photos/measure/messages.py" line="105"/>
        <source>The measurement {name} can&apos;t be read ({error}); remove it from the folder or correct it.</source>
        <translation>Nie można odczytać pomiaru {name} ({error}); usuń go z katalogu albo popraw.</translation>
    </message>
    <message>
        <location filename="../plugin/photos/measure/messages.py" line="106"/>
        <source>The mark &apos;{mark}&apos; in {name} has no column and row; complete or remove it.</source>
        <translation>Znaczek „{mark}” w {name} nie ma kolumny ani wiersza; uzupełnij go lub usuń.</translation>
    </message>
    <message>
        <location filename="../plugin/photos/measure/messages.py" line="107"/>
        <source>Give each of the two measurements either as a layer or as a folder.</source>
        <translation>Podaj każdy z dwóch pomiarów albo jako warstwę, albo jako katalog.</translation>
    </message>
    <message>
        <location filename="../plugin/photos/measure/messages.py" line="111"/>
        <source>Marks in only one of the measurements, which are not compared: {count} ({names}).</source>
        <translation>Znaczki, które ma tylko jeden z pomiarów i które nie są porównywane: {count} ({names}).</translation>
    </message>
    <message>
        <location filename="../plugin/photos/measure/messages.py" line="114"/>
        <source>A measurement has the mark &apos;{mark}&apos; twice{where}; give both layers a field &apos;photo&apos; that tells photos apart.</source>
        <translation>Pomiar zawiera znaczek „{mark}” dwa razy{where}; dodaj w obu warstwach pole „photo”, które rozróżnia zdjęcia.</translation>
    </message>
    <message>
        <location filename="../plugin/photos/measure/messages.py" line="119"/>
        <source>The two measurements have no mark in common ({first}; {second}); check their fields &apos;mark&apos; and &apos;photo&apos;.</source>
        <translation>Oba pomiary nie mają wspólnego znaczka ({first}; {second}); sprawdź ich pola „mark” i „photo”.</translation>
    </message>
    <message>
        <location filename="../plugin/photos/measure/messages.py" line="128"/>
        <source>correlation</source>
        <translation>korelacja</translation>
    </message>
    <message>
        <location filename="../plugin/photos/measure/messages.py" line="128"/>
        <source>brightness</source>
        <translation>jasność</translation>
    </message>
    <message>
        <location filename="../plugin/photos/measure/messages.py" line="129"/>
        <source>cross</source>
        <translation>krzyż</translation>
    </message>
    <message>
        <location filename="../plugin/photos/measure/messages.py" line="129"/>
        <source>dot</source>
        <translation>kropka</translation>
    </message>
    <message>
        <location filename="../plugin/photos/measure/messages.py" line="129"/>
        <source>ring with dot</source>
        <translation>pierścień z kropką</translation>
    </message>
    <message>
        <location filename="../plugin/photos/measure/messages.py" line="129"/>
        <source>ring with cross</source>
        <translation>pierścień z krzyżem</translation>
    </message>
    <message>
        <location filename="../plugin/photos/measure/messages.py" line="130"/>
        <source>wedge</source>
        <translation>klin</translation>
    </message>
    <message>
        <location filename="../plugin/photos/interiororientation.py" line="58"/>
        <source>The scan: any raster that GDAL reads, 1 to 16 bit or more; colour is turned to grey. Black is a grey value even if the file calls it nodata.</source>
        <translation>Skan: dowolny raster, który odczytuje GDAL, od 1 do 16 bitów lub więcej; barwa jest zamieniana na odcienie szarości. Czerń jest wartością szarości, choćby plik oznaczał ją jako brak danych.</translation>
    </message>
    <message>
        <location filename="../plugin/photos/interiororientation.py" line="67"/>
        <source>A mark cut out of this photo or one like it, with some ground around. It is used for its own mark first; marks that look different are measured by drawn ones. A template that looks the same when turned by 180 degrees is measured by its centre of symmetry, else by its middle.</source>
        <translation>Znaczek wycięty z tego lub podobnego zdjęcia, z kawałkiem tła wokół. Służy najpierw do pomiaru swojego znaczka; znaczki o innym wyglądzie są mierzone wzorcami rysowanymi. Wzorzec, który po obrocie o 180 stopni wygląda tak samo, jest mierzony względem własnego środka symetrii, inny – względem środka wycinka.</translation>
    </message>
    <message>
        <location filename="../plugin/photos/interiororientation.py" line="77"/>
        <source>Off: the positions were measured by hand and are taken as they are; the other marks are measured. One that is off by more than a thousandth of the frame fails like a measured mark.</source>
        <translation>Wyłączone: położenia zmierzono ręcznie i są brane bez zmian; pozostałe znaczki są mierzone. Znaczek odległy o więcej niż jedną tysięczną ramki jest odrzucany tak samo jak zmierzony.</translation>
    </message>
    <message>
        <location filename="../plugin/photos/interiororientation.py" line="112"/>
        <source>MicMac measurement</source>
        <translation>Pomiar MicMac</translation>
    </message>
    <message>
        <location filename="../plugin/photos/interiororientation.py" line="112"/>
        <source>XML files (*.xml)</source>
        <translation>Pliki XML (*.xml)</translation>
    </message>
    <message>
        <location filename="../plugin/photos/interiororientation.py" line="113"/>
        <source>The measured and given marks as MicMac reads them: save it as Ori-InterneScan/MeasuresIm-PHOTO.xml, with the photo&apos;s whole file name, as in MeasuresIm-114.jpg.xml.</source>
        <translation>Zmierzone i podane znaczki w postaci, którą odczytuje MicMac: zapisz jako Ori-InterneScan/MeasuresIm-PHOTO.xml, z pełną nazwą pliku zdjęcia, jak w MeasuresIm-114.jpg.xml.</translation>
    </message>
    <message>
        <location filename="../plugin/photos/comparemarks.py" line="46"/>
        <source>Compares two measurements of the same marks: count, mean, standard deviation, maximum and minimum of the distances, in pixels and micrometres, as tables 1 to 4 of Mikrut and Chwastek 2007 do, and whether the mean is within a limit. Two operators differed there by 0.25 px, so a program has to stay within that. Many photos are compared in one run: give folders, or merged layers with a field &apos;photo&apos;.</source>
        <translation>Porównuje dwa pomiary tych samych znaczków: liczba, średnia, odchylenie standardowe, maksimum i minimum odległości, w pikselach i mikrometrach, jak w tabelach od 1 do 4 pracy Mikruta i Chwastka z 2007 r., oraz czy średnia mieści się w granicy. Dwaj operatorzy różnili się tam o 0,25 px, więc program musi się w tym zmieścić. Wiele zdjęć porównuje się za jednym razem: podaj katalogi albo połączone warstwy z polem „photo”.</translation>
    </message>
    <message>
        <location filename="../plugin/photos/comparemarks.py" line="58"/>
        <source>Instead of the layer: all files of this folder, layers with the field &apos;mark&apos; (of the photo named in their field &apos;photo&apos;, else in the file&apos;s name) and MicMac&apos;s MeasuresIm-*.xml.</source>
        <translation>Zamiast warstwy: wszystkie pliki tego katalogu, warstwy z polem „mark” (dla zdjęcia z ich pola „photo”, a bez niego dla zdjęcia o nazwie pliku) oraz pliki MeasuresIm-*.xml z programu MicMac.</translation>
    </message>
    <message>
        <location filename="../plugin/photos/comparemarks.py" line="62"/>
        <source>First measurement, a folder</source>
        <translation>Pierwszy pomiar, katalog</translation>
    </message>
    <message>
        <location filename="../plugin/photos/comparemarks.py" line="63"/>
        <source>Second measurement, a folder</source>
        <translation>Drugi pomiar, katalog</translation>
    </message>
    <message>
        <location filename="../plugin/photos/comparemarks.py" line="67"/>
        <source>Largest mean distance (px)</source>
        <translation>Największa średnia odległość (px)</translation>
    </message>
    <message>
        <location filename="../plugin/photos/comparemarks.py" line="69"/>
        <source>The verdict is &apos;within&apos; where the mean distance is at most this; in the paper 0.25 px.</source>
        <translation>Ocena brzmi „within”, gdy średnia odległość jest nie większa; w artykule 0,25 px.</translation>
    </message>
    <message>
        <location filename="../plugin/photos/comparemarks.py" line="75"/>
        <source>Count, mean, standard deviation, maximum and minimum of the distances, the limit and the verdict, a row for each unit.</source>
        <translation>Liczba, średnia, odchylenie standardowe, maksimum i minimum odległości, granica i ocena, po jednym wierszu na jednostkę.</translation>
    </message>
    <message>
        <location filename="../plugin/photos/comparemarks.py" line="78"/>
        <source>Photos</source>
        <translation>Zdjęcia</translation>
    </message>
    <message>
        <location filename="../plugin/photos/comparemarks.py" line="79"/>
        <source>Count, mean, maximum (px) and verdict of each photo.</source>
        <translation>Liczba, średnia, maksimum (px) i ocena każdego zdjęcia.</translation>
    </message>
    <message>
        <location filename="../plugin/photos/comparemarks.py" line="87"/>
        <source>Marks in both measurements</source>
        <translation>Znaczki w obu pomiarach</translation>
    </message>
    <message>
        <location filename="../plugin/photos/comparemarks.py" line="88"/>
        <source>1 where the mean distance is within the limit, else 0</source>
        <translation>1, gdy średnia odległość mieści się w granicy, w przeciwnym razie 0</translation>
    </message>
    <message>
        <location filename="../plugin/photos/comparemarks.py" line="143"/>
        <source>The mean distance is within the limit of {limit:g} px.</source>
        <translation>Średnia odległość mieści się w granicy {limit:g} px.</translation>
    </message>
    <message>
        <location filename="../plugin/photos/comparemarks.py" line="144"/>
        <source>The mean distance is beyond the limit of {limit:g} px.</source>
        <translation>Średnia odległość przekracza granicę {limit:g} px.</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/paper/inspection_record.py" line="66"/>
        <source>Acceptance of an orthophoto mosaic</source>
        <translation>Odbiór ortofotomapy</translation>
    </message>
    <message>
        <source>rule</source>
        <translation>reguła</translation>
    </message>
    <message>
        <source>value</source>
        <translation>wartość</translation>
    </message>
    <message>
        <source>inspected by</source>
        <translation>osoba kontrolująca</translation>
    </message>
    <message>
        <source>decided by</source>
        <translation>osoba decydująca</translation>
    </message>
    <message>
        <source>Where the seams failed</source>
        <translation>Gdzie linie mozaikowania są niezgodne</translation>
    </message>
    <message>
        <source>The pieces of seam of the sample; numbers are those of the failures below.</source>
        <translation>Odcinki linii z próby; liczby to numery usterek podanych niżej.</translation>
    </message>
    <message>
        <source>The seams of all sheets; numbers are those of the failures below.</source>
        <translation>Linie mozaikowania wszystkich arkuszy; liczby to numery usterek podanych niżej.</translation>
    </message>
    <message>
        <location filename="../plugin/toolkit/layer_styles.py" line="55"/>
        <source>sheet</source>
        <translation>arkusz</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/paper/acceptance_report.py" line="137"/>
        <source>seams</source>
        <translation>linie mozaikowania</translation>
    </message>
    <message>
        <source>measured</source>
        <translation>zmierzono</translation>
    </message>
    <message>
        <source>metres failed</source>
        <translation>metry niezgodne</translation>
    </message>
    <message>
        <source>share failed</source>
        <translation>udział niezgodnych</translation>
    </message>
    <message>
        <source>longest failure</source>
        <translation>najdłuższa usterka</translation>
    </message>
    <message>
        <source>pieces failed</source>
        <translation>niezgodne odcinki</translation>
    </message>
    <message>
        <source>no.</source>
        <translation>nr</translation>
    </message>
    <message>
        <source>length</source>
        <translation>długość</translation>
    </message>
    <message>
        <source>kept (95 %)</source>
        <translation>zachowano (95 %)</translation>
    </message>
    <message>
        <source>band width</source>
        <translation>szerokość pasa</translation>
    </message>
    <message>
        <source>orthoimages (dates)</source>
        <translation>ortoobrazy (daty)</translation>
    </message>
    <message>
        <source>place</source>
        <translation>miejsce</translation>
    </message>
    <message>
        <source>cause, remark</source>
        <translation>przyczyna, uwaga</translation>
    </message>
    <message>
        <source>The longest {shown} of {count} failures; all of them are in the layer of failures.</source>
        <translation>Najdłuższe usterki: {shown} z {count}; wszystkie są w warstwie usterek.</translation>
    </message>
    <message>
        <source>Pictures of the longest {shown} of {count} failures.</source>
        <translation>Obrazy najdłuższych usterek: {shown} z {count}.</translation>
    </message>
    <message>
        <source>seams read from</source>
        <translation>linie mozaikowania wczytane z</translation>
    </message>
    <message>
        <source>And {count} more.</source>
        <translation>I jeszcze: {count}.</translation>
    </message>
    <message>
        <source>Kept: the share of the orthoimages&apos; finest detail that is left in the strip along a piece of seam, relative to the ground around it, so that what was done to the whole mosaic does not count; with its 95 % interval.</source>
        <translation>Zachowane: część najdrobniejszych detali ortoobrazów, która pozostała w pasie wzdłuż odcinka linii mozaikowania, w odniesieniu do terenu obok, więc to, co zrobiono z całą ortofotomapą, się nie liczy; z 95 % przedziałem ufności.</translation>
    </message>
    <message>
        <source>Windows: {count}, flagged: {flagged}</source>
        <translation>Okna: {count}, oznaczone: {flagged}</translation>
    </message>
    <message>
        <source>Flagged: a significant loss, or one that the observer saw.</source>
        <translation>Oznaczona jest strata istotna lub zauważona przez obserwatora.</translation>
    </message>
    <message>
        <source>lost detail over the mosaic; in the frame the clips</source>
        <translation>strata detali na tle ortofotomapy; w ramce wycinki</translation>
    </message>
    <message>
        <source>element</source>
        <translation>element</translation>
    </message>
    <message>
        <source>How it was measured</source>
        <translation>Jak przebiegał pomiar</translation>
    </message>
    <message>
        <source>date</source>
        <translation>data</translation>
    </message>
    <message>
        <source>software</source>
        <translation>oprogramowanie</translation>
    </message>
    <message>
        <source>name and office</source>
        <translation>nazwisko i stanowisko</translation>
    </message>
    <message>
        <source>place and date</source>
        <translation>miejsce i data</translation>
    </message>
    <message>
        <source>signature</source>
        <translation>podpis</translation>
    </message>
    <message>
        <source>file</source>
        <translation>plik</translation>
    </message>
    <message>
        <source>size</source>
        <translation>wielkość</translation>
    </message>
    <message>
        <source>bands</source>
        <translation>kanały</translation>
    </message>
    <message>
        <source>How the quality was measured, by {software}.</source>
        <translation>Jak zmierzono jakość, program {software}.</translation>
    </message>
    <message>
        <source>decision</source>
        <translation>decyzja</translation>
    </message>
    <message>
        <source>number</source>
        <translation>numer</translation>
    </message>
    <message>
        <source>where</source>
        <translation>gdzie</translation>
    </message>
    <message>
        <source>coordinates</source>
        <translation>współrzędne</translation>
    </message>
    <message>
        <source>The numbers are those of the table.</source>
        <translation>Liczby są zgodne z tabelą.</translation>
    </message>
    <message>
        <source>The available range is not known.</source>
        <translation>Dostępny zakres nie jest znany.</translation>
    </message>
    <message>
        <source>Sources of the limits</source>
        <translation>Źródła granic</translation>
    </message>
    <message>
        <source>The figures</source>
        <translation>Wartości</translation>
    </message>
    <message>
        <source>Colour balance: the means of red, green and blue on the grey areas that were given, each area counted once; their largest difference as a share of the range. Without such areas it is not measurable.</source>
        <translation>Balans barw: średnie czerwieni, zieleni i niebieskiego na podanych szarych obszarach, każdy obszar liczony raz; największa różnica między nimi jako część zakresu. Bez takich obszarów nie można go zmierzyć.</translation>
    </message>
    <message>
        <source>Groups are compared by their luminance, or the first band.</source>
        <translation>Grupy są porównywane według luminancji albo pierwszego kanału.</translation>
    </message>
    <message>
        <source>Each window is decomposed by the wavelet {wavelet} on {levels} levels; a level&apos;s detail is the share of the window&apos;s variance in its three detail components. A window is judged by its noisiest band; one that several images of a group show counts once (Pyka 2009).</source>
        <translation>Każde okno jest rozkładane falką {wavelet} na {levels} {levels:poziom|poziomy|poziomów}; detale poziomu to udział jego trzech komponentów detalicznych w wariancji okna. Okno jest oceniane według kanału o największym szumie; okno, które pokazuje kilka obrazów grupy, liczy się raz (Pyka 2009).</translation>
    </message>
    <message>
        <source>Kurtosis is the fourth moment of a level&apos;s details over their squared variance: 3 for Gaussian noise, more where edges stand out of a quiet ground. Coefficients that wrap around to the window&apos;s opposite border are left out.</source>
        <translation>Kurtoza to czwarty moment detali poziomu podzielony przez kwadrat ich wariancji: 3 dla szumu gaussowskiego, więcej tam, gdzie krawędzie wyróżniają się na spokojnym tle. Współczynniki, na które wpływa przeciwległy brzeg okna, nie są brane pod uwagę.</translation>
    </message>
    <message>
        <source>± is one standard deviation, from the errors of the amplitudes. A distance is that of a group, so it may also be too coarse by up to one step of the target.</source>
        <translation>± oznacza jedno odchylenie standardowe, z błędów amplitud. Wymiar jest wymiarem grupy, więc może ponadto leżeć do jednego kroku testu po stronie grubszych grup.</translation>
    </message>
    <message>
        <source>Observers</source>
        <translation>Obserwatorzy</translation>
    </message>
    <message>
        <source>The finest group whose bars an observer can tell apart, with all coarser groups resolved.</source>
        <translation>Najdrobniejsza grupa, której paski obserwator rozróżnia, przed pierwszą nierozróżnioną.</translation>
    </message>
    <message>
        <source>along the flight, cm</source>
        <translation>wzdłuż kierunku lotu, cm</translation>
    </message>
    <message>
        <source>across the flight, cm</source>
        <translation>w poprzek kierunku lotu, cm</translation>
    </message>
    <message>
        <source>contrast of the target</source>
        <translation>kontrast testu</translation>
    </message>
    <message>
        <source>bars to gaps of the coarsest group</source>
        <translation>paski do przerw najgrubszej grupy</translation>
    </message>
    <message>
        <source>Full circles are bars, empty ones the gaps between them. The gaps&apos; mean must lie beyond the dashed line, which is {criterion:.0%} of the full amplitude away from the inner bars. Grey lines: the ends of the line as drawn.</source>
        <translation>Pełne kółka to paski, puste – przerwy między nimi. Średnia przerw musi leżeć za linią przerywaną, która jest oddalona od wewnętrznych pasków o {criterion:.0%} pełnej amplitudy. Szare linie: końce narysowanej linii.</translation>
    </message>
    <message>
        <source>Values in DN, places along the line in px.</source>
        <translation>Wartości w DN, położenia wzdłuż linii w px.</translation>
    </message>
    <message>
        <source>± cm</source>
        <translation>± cm</translation>
    </message>
    <message>
        <source>± DN</source>
        <translation>± DN</translation>
    </message>
    <message>
        <source>groups</source>
        <translation>grupy</translation>
    </message>
    <message>
        <source>given</source>
        <translation>podane</translation>
    </message>
    <message>
        <source>ISO 2859-1, level II, AQL 1.0</source>
        <translation>ISO 2859-1, poziom II, AQL 1,0</translation>
    </message>
    <message>
        <source>Seam Inspector: where a piece of seam is called significant</source>
        <translation>Seam Inspector: granica, od której strata na odcinku linii mozaikowania jest istotna</translation>
    </message>
    <message>
        <source>ISO 2859-1:1999, single sampling, normal inspection</source>
        <translation>ISO 2859-1:1999, plan jednostopniowy, kontrola normalna</translation>
    </message>
    <message>
        <source>Seam Inspector: nothing is accepted on a guess</source>
        <translation>Seam Inspector: nic nie jest przyjmowane na domysł</translation>
    </message>
    <message>
        <source>ISO 2859-1, level II, AQL 4.0</source>
        <translation>ISO 2859-1, poziom II, AQL 4,0</translation>
    </message>
    <message>
        <source>2 % of the seams may fail if it is not contiguous</source>
        <translation>niezgodne może być 2 % linii mozaikowania, byle nie w jednym ciągu</translation>
    </message>
    <message>
        <source>Beeldmateriaal Nederland: 2 % may deviate</source>
        <translation>Beeldmateriaal Nederland: odstępstwo może mieć 2 %</translation>
    </message>
    <message>
        <source>Beeldmateriaal Nederland: if it is not contiguous; 50 m is half a standard window (Pyka 2010)</source>
        <translation>Beeldmateriaal Nederland: byle nie w jednym ciągu; 50 m to połowa okna standardowego (Pyka 2010)</translation>
    </message>
    <message>
        <source>Strict: 1 % may fail, 25 m without a break</source>
        <translation>surowe: niezgodny może być 1 %, 25 m bez przerwy</translation>
    </message>
    <message>
        <source>Seam Inspector: stricter than what is called significant</source>
        <translation>Seam Inspector: surowiej niż granica istotnej straty</translation>
    </message>
    <message>
        <source>Seam Inspector: half of what Beeldmateriaal Nederland lets deviate</source>
        <translation>Seam Inspector: połowa odstępstwa dopuszczanego przez Beeldmateriaal Nederland</translation>
    </message>
    <message>
        <source>Seam Inspector: one standard piece of seam</source>
        <translation>Seam Inspector: jeden standardowy odcinek linii mozaikowania</translation>
    </message>
    <message>
        <source>JRC orthoimage specification for LPIS</source>
        <translation>specyfikacja JRC dla ortoobrazów LPIS</translation>
    </message>
    <message>
        <source>JRC, Orthoimage technical specifications for the purpose of LPIS: overall clipping</source>
        <translation>JRC, Orthoimage technical specifications for the purpose of LPIS: obcięcie</translation>
    </message>
    <message>
        <source>JRC, Orthoimage technical specifications for the purpose of LPIS: histogram peak</source>
        <translation>JRC, Orthoimage technical specifications for the purpose of LPIS: maksimum histogramu</translation>
    </message>
    <message>
        <source>JRC, Orthoimage technical specifications for the purpose of LPIS: contrast</source>
        <translation>JRC, Orthoimage technical specifications for the purpose of LPIS: kontrast</translation>
    </message>
    <message>
        <source>JRC, Orthoimage technical specifications for the purpose of LPIS: noise</source>
        <translation>JRC, Orthoimage technical specifications for the purpose of LPIS: szum</translation>
    </message>
    <message>
        <source>JRC, Orthoimage technical specifications for the purpose of LPIS: colour balance</source>
        <translation>JRC, Orthoimage technical specifications for the purpose of LPIS: balans barw</translation>
    </message>
    <message>
        <source>Arrêté du 16 septembre 2003, section 8.4 (France)</source>
        <translation>Arrêté du 16 septembre 2003, rozdział 8.4 (Francja)</translation>
    </message>
    <message>
        <source>Pyka 2010: tonal unity at the seams is bought with contrast</source>
        <translation>Pyka 2010: jednolitość tonalna przy liniach mozaikowania kosztuje kontrast</translation>
    </message>
    <message>
        <source>JRC orthoimage specification for LPIS, each band held to the limits</source>
        <translation>specyfikacja JRC dla ortoobrazów LPIS, granice dla każdego kanału</translation>
    </message>
    <message>
        <source>Places windows of about 100 m along the seamlines of a mosaic and measures in each how much local contrast the mosaic kept against its sources.</source>
        <translation>Rozmieszcza okna o boku około 100 m wzdłuż linii mozaikowania ortofotomapy i mierzy w każdym, ile lokalnego kontrastu zachowała ona względem ortoobrazów źródłowych.</translation>
    </message>
    <message>
        <source>The rectangles as measured, with their verdict, what it is based on, and causes.</source>
        <translation>Prostokąty w zmierzonych granicach, z oceną, jej podstawą i przyczynami.</translation>
    </message>
    <message>
        <source>A tile index of orthoimages as gdaltindex writes it, alone or beside the sources.</source>
        <translation>Indeks kafli ortoobrazów w postaci zapisywanej przez gdaltindex, sam albo obok ortoobrazów źródłowych.</translation>
    </message>
    <message>
        <source>The orthoimages that the mosaic was made from.</source>
        <translation>Ortoobrazy, z których powstała ortofotomapa.</translation>
    </message>
    <message>
        <source>Steps of the decomposition.</source>
        <translation>Liczba kroków dekompozycji.</translation>
    </message>
    <message>
        <source>The orthophoto mosaic under inspection.</source>
        <translation>Kontrolowana ortofotomapa.</translation>
    </message>
    <message>
        <source>Lines, or polygons that are each filled from one orthoimage.</source>
        <translation>Linie albo poligony, z których każdy jest wypełniony jednym ortoobrazem.</translation>
    </message>
    <message>
        <source>Minimum side of a window.</source>
        <translation>Najmniejsza dopuszczalna długość boku okna.</translation>
    </message>
    <message>
        <source>Or their tile index, as gdaltindex writes it.</source>
        <translation>Albo ich indeks kafli w postaci zapisywanej przez gdaltindex.</translation>
    </message>
    <message>
        <source>The orthoimages the mosaic was made from.</source>
        <translation>Ortoobrazy, z których powstała ortofotomapa.</translation>
    </message>
    <message>
        <source>Distance between neighbouring windows along the seam.</source>
        <translation>Odległość między sąsiednimi oknami wzdłuż linii mozaikowania.</translation>
    </message>
    <message>
        <source>Inspect mosaic</source>
        <translation>Skontroluj ortofotomapę</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/measure/acceptance_rules.py" line="27"/>
        <source>Seam Inspector&apos;s own</source>
        <translation>granica własna wtyczki Seam Inspector</translation>
    </message>
    <message>
        <location filename="../plugin/imagery/messages.py" line="15"/>
        <source>{name} is a device, a pipe or memory, not a file; copy its data to a file.</source>
        <translation>{name} jest urządzeniem, potokiem albo pamięcią, a nie plikiem; skopiuj dane do pliku.</translation>
    </message>
    <message>
        <location filename="../plugin/imagery/messages.py" line="23"/>
        <source>{width} x {height} px of {name} are too many to be read at once; cut out the part that is needed.</source>
        <translation>{width} × {height} px rastra {name} to za dużo, aby odczytać je naraz; wytnij potrzebną część.</translation>
    </message>
    <message>
        <location filename="../plugin/plugin.py" line="49"/>
        <source>The first inspection in five minutes, and a page for every algorithm</source>
        <translation>Pierwsza kontrola w pięć minut i strona o każdym algorytmie</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/dock.py" line="224"/>
        <source>Help</source>
        <translation>Pomoc</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/dock.py" line="224"/>
        <source>How a first inspection goes, in the browser</source>
        <translation>Jak przebiega pierwsza kontrola, w przeglądarce</translation>
    </message>
    <message>
        <location filename="../plugin/imagery/messages.py" line="95"/>
        <source>&apos;{output}&apos; is to be written to {path}, which is not a file on a disk; choose a file.</source>
        <translation>Wynik „{output}” ma być zapisany w {path}, a to nie jest plik na dysku; wybierz plik.</translation>
    </message>
    <message>
        <location filename="../plugin/toolkit/messages.py" line="62"/>
        <source>{path} holds {held} of {count} features, as the rest can&apos;t be written; make room on the disk, and run this again.</source>
        <translation>W pliku {path} jest {held} z {count} obiektów, ponieważ reszty nie można zapisać; zwolnij miejsce na dysku i uruchom narzędzie ponownie.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/judging.py" line="60"/>
        <source>nothing to judge yet</source>
        <translation>jeszcze nic do oceny</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/judge_bar.py" line="195"/>
        <source>Remark on window {number}:</source>
        <translation>Uwaga do okna {number}:</translation>
    </message>
    <message>
        <location filename="../plugin/toolkit/messages.py" line="24"/>
        <source>&apos;{parameter}&apos; is {value}, which is not a coordinate reference system; choose one.</source>
        <translation>„{parameter}” ma wartość {value}, a to nie jest układ współrzędnych; wybierz układ.</translation>
    </message>
    <message>
        <location filename="../plugin/imagery/messages.py" line="105"/>
        <source>The rules in {name} are not valid JSON (see line {line}); correct the file.</source>
        <translation>Reguły w pliku {name} nie są poprawnym JSON (zob. wiersz {line}); popraw plik.</translation>
    </message>
    <message>
        <location filename="../plugin/photos/comparemarks.py" line="71"/>
        <source>Pixel size (µm)</source>
        <translation>Wielkość piksela (µm)</translation>
    </message>
    <message>
        <location filename="../plugin/photos/interiororientation.py" line="121"/>
        <source>Root mean square of the residuals (µm)</source>
        <translation>Średnia kwadratowa odchyłek (µm)</translation>
    </message>
    <message>
        <location filename="../plugin/photos/interiororientation.py" line="195"/>
        <source>{marks} marks, {model} model, root mean square of the residuals {rms:.1f} µm.</source>
        <translation>{marks} {marks:znaczek|znaczki|znaczków}, model {model}, średnia kwadratowa odchyłek {rms:.1f} µm.</translation>
    </message>
    <message>
        <location filename="../plugin/photos/interiororientation.py" line="104"/>
        <source>A point for each mark of the calibration: column and row (pixel centres at .5), millimetres, residuals in µm, correlation, status, reason and the photo&apos;s name.</source>
        <translation>Punkt dla każdego znaczka kalibracji: kolumna i wiersz (środki pikseli mają końcówkę ,5), milimetry, odchyłki w µm, korelacja, stan, przyczyna i nazwa zdjęcia.</translation>
    </message>
    <message>
        <source>Residual x, µm</source>
        <translation>Odchyłka x, µm</translation>
    </message>
    <message>
        <source>Residual y, µm</source>
        <translation>Odchyłka y, µm</translation>
    </message>
    <message>
        <location filename="../plugin/resolution/simulatebayer.py" line="43"/>
        <source>A GeoTIFF: red, green and blue on the image&apos;s own pixels, in its data type.</source>
        <translation>Plik GeoTIFF: czerwony, zielony i niebieski w pikselach obrazu i w jego typie danych.</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/fitsensormodel.py" line="85"/>
        <source>GeoTIFF files (*.tif *.tiff *.TIF *.TIFF)</source>
        <translation>Pliki GeoTIFF (*.tif *.tiff *.TIF *.TIFF)</translation>
    </message>
    <message>
        <location filename="../plugin/seams/report/flagged_windows.py" line="201"/>
        <source>clips of {side} px a side around x {x}, y {y}, at 2x on the screen.</source>
        <translation>wycinki o boku {side} px wokół x {x}, y {y}, na ekranie w powiększeniu 2×.</translation>
    </message>
    <message>
        <source>Based on ratio 1 of whole windows. Significant: {limit:.2f} or less. Reduced: below 1. Preserved: 1 or more.</source>
        <translation>Patrzy na stosunek 1 w całych oknach. Istotna strata: {limit:.2f} lub mniej. Osłabione: poniżej 1. Zachowane: 1 lub więcej.</translation>
    </message>
    <message>
        <source>flagged</source>
        <translation>oznaczone</translation>
    </message>
    <message>
        <source>Has a significant loss, or one that the observer saw.</source>
        <translation>Okno z istotną stratą lub ze stratą, którą zauważył obserwator.</translation>
    </message>
    <message>
        <source>the paper&apos;s rule</source>
        <translation>reguła z artykułu</translation>
    </message>
    <message>
        <source>What the operator saw at 2x magnification.</source>
        <translation>Co operator widział w powiększeniu 2×.</translation>
    </message>
    <message>
        <source>The share of the sources&apos; finest detail that is left in the strip along the seam, relative to the ground around it, so that what was done to the whole mosaic does not count; in brackets its 95 % interval. 0.5 is what is left where two images that have nothing in common were averaged.</source>
        <translation>Część najdrobniejszych detali ortoobrazów źródłowych, która została w pasie wzdłuż linii mozaikowania, w odniesieniu do terenu wokół, tak że to, co zrobiono z całą ortofotomapą, się nie liczy; w nawiasie przedział ufności 95 %. 0,5 zostaje tam, gdzie uśredniono dwa obrazy, które nie mają nic wspólnego.</translation>
    </message>
    <message>
        <source>The mosaic&apos;s relative variance at level 1 divided by a source&apos;s; a window&apos;s is the largest over its sources.</source>
        <translation>Wariancja względna ortofotomapy na poziomie 1 podzielona przez wariancję ortoobrazu źródłowego; stosunek okna jest największym spośród jego źródeł.</translation>
    </message>
    <message>
        <source>The share of a clip&apos;s variance that lies in the details of each level, and in the background that is left (wavelet decomposition; Pyka 2010).</source>
        <translation>Część wariancji wycinka przypadająca na detale każdego poziomu i na pozostałe tło (dekompozycja falkowa; Pyka 2010).</translation>
    </message>
    <message>
        <source>level of detail</source>
        <translation>poziom detali</translation>
    </message>
    <message>
        <source>Level 1 is the finest, about 2 px; each further one is twice as coarse.</source>
        <translation>Poziom 1 jest najdrobniejszy, około 2 px; każdy następny jest dwa razy grubszy.</translation>
    </message>
    <message>
        <source>sharpness 1</source>
        <translation>ostrość 1</translation>
    </message>
    <message>
        <source>The contrast of the finest detail in the whole window, 1 for that of its sources in the mosaic&apos;s tones.</source>
        <translation>Kontrast najdrobniejszych detali w całym oknie; 1 to kontrast jego ortoobrazów źródłowych w tonach ortofotomapy.</translation>
    </message>
    <message>
        <source>The mosaic as it would be if its sources were cut along the seam without any mixing.</source>
        <translation>Czym byłaby ortofotomapa, gdyby jej źródła przycięto wzdłuż linii mozaikowania i niczego nie zmieszano.</translation>
    </message>
    <message>
        <source>What would be left of the sources&apos; detail if the two were averaged.</source>
        <translation>Ile zostałoby z detali ortoobrazów źródłowych, gdyby dwa z nich uśredniono.</translation>
    </message>
    <message>
        <source>seam profile</source>
        <translation>profil linii mozaikowania</translation>
    </message>
    <message>
        <source>lost detail</source>
        <translation>utracone detale</translation>
    </message>
    <message>
        <source>The colours show how much of the finest detail is kept, relative to the ground around; ground without a colour is even.</source>
        <translation>Barwy pokazują, ile najdrobniejszych detali zachowano w odniesieniu do terenu wokół; teren bez barwy jest jednolity.</translation>
    </message>
    <message>
        <source>clips</source>
        <translation>wycinki</translation>
    </message>
    <message>
        <source>The part of the window where the mosaic lost most of the finest detail, all stretched alike. JPEG takes a little detail from all of them.</source>
        <translation>Część okna, w której ortofotomapa straciła najwięcej najdrobniejszych detali, wszystkie z jednakowym rozciągnięciem. JPEG zabiera ich trochę wszystkim.</translation>
    </message>
    <message>
        <source>what it means</source>
        <translation>co to znaczy</translation>
    </message>
    <message>
        <source>How to read this</source>
        <translation>Jak to czytać</translation>
    </message>
    <message>
        <source>Window {number}: {place}</source>
        <translation>Okno {number}: {place}</translation>
    </message>
    <message>
        <source>Window {number}: relative variance by level</source>
        <translation>Okno {number}: wariancja względna według poziomów</translation>
    </message>
    <message>
        <location filename="../plugin/toolkit/layer_styles.py" line="30"/>
        <source>station (m)</source>
        <translation>pikietaż (m)</translation>
    </message>
    <message>
        <location filename="../plugin/toolkit/layer_styles.py" line="31"/>
        <source>length (m)</source>
        <translation>długość (m)</translation>
    </message>
    <message>
        <location filename="../plugin/toolkit/layer_styles.py" line="35"/>
        <source>verdict by the paper&apos;s rule</source>
        <translation>ocena według reguły z artykułu</translation>
    </message>
    <message>
        <location filename="../plugin/toolkit/layer_styles.py" line="36"/>
        <source>verdict against</source>
        <translation>ocena względem</translation>
    </message>
    <message>
        <location filename="../plugin/toolkit/layer_styles.py" line="38"/>
        <source>sources that were used</source>
        <translation>liczba ortoobrazów źródłowych</translation>
    </message>
    <message>
        <location filename="../plugin/toolkit/layer_styles.py" line="40"/>
        <source>orthoimage on the left</source>
        <translation>ortoobraz z lewej</translation>
    </message>
    <message>
        <location filename="../plugin/toolkit/layer_styles.py" line="41"/>
        <source>orthoimage on the right</source>
        <translation>ortoobraz z prawej</translation>
    </message>
    <message>
        <location filename="../plugin/toolkit/layer_styles.py" line="42"/>
        <source>its date, left</source>
        <translation>jego data, z lewej</translation>
    </message>
    <message>
        <location filename="../plugin/toolkit/layer_styles.py" line="43"/>
        <source>its date, right</source>
        <translation>jego data, z prawej</translation>
    </message>
    <message>
        <location filename="../plugin/seams/measure/window/window_tables.py" line="95"/>
        <source>ratio of the background</source>
        <translation>stosunek tła</translation>
    </message>
    <message>
        <location filename="../plugin/toolkit/layer_styles.py" line="44"/>
        <source>kept 1, at least</source>
        <translation>zachowane 1, co najmniej</translation>
    </message>
    <message>
        <location filename="../plugin/toolkit/layer_styles.py" line="46"/>
        <source>kept 1, at most</source>
        <translation>zachowane 1, co najwyżej</translation>
    </message>
    <message>
        <location filename="../plugin/toolkit/layer_styles.py" line="47"/>
        <source>width of the band (m)</source>
        <translation>szerokość pasa (m)</translation>
    </message>
    <message>
        <location filename="../plugin/seams/measure/window/window_tables.py" line="108"/>
        <source>share where no source wins clearly</source>
        <translation>udział pikseli, gdzie żadne źródło nie przeważa</translation>
    </message>
    <message>
        <location filename="../plugin/seams/measure/window/window_tables.py" line="124"/>
        <source>share that the sources explain</source>
        <translation>udział pikseli objaśnionych przez źródła</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/windows/window_columns.py" line="141"/>
        <source>sure (%)</source>
        <translation>pewność (%)</translation>
    </message>
    <message>
        <location filename="../plugin/seams/measure/window/window_tables.py" line="136"/>
        <source>sure 2 (%)</source>
        <translation>pewność 2 (%)</translation>
    </message>
    <message>
        <location filename="../plugin/toolkit/layer_styles.py" line="54"/>
        <source>failure</source>
        <translation>usterka</translation>
    </message>
    <message>
        <location filename="../plugin/toolkit/layer_styles.py" line="56"/>
        <source>picture</source>
        <translation>obraz</translation>
    </message>
    <message>
        <location filename="../plugin/toolkit/layer_styles.py" line="59"/>
        <source>kept {level}</source>
        <translation>zachowane {level}</translation>
    </message>
    <message>
        <location filename="../plugin/seams/measure/window/window_tables.py" line="101"/>
        <source>ratio {level} against the composite</source>
        <translation>stosunek {level} względem kompozycji</translation>
    </message>
    <message>
        <location filename="../plugin/seams/measure/window/window_tables.py" line="105"/>
        <source>ratio {level} expected of a feather</source>
        <translation>stosunek {level} oczekiwany po wtapianiu</translation>
    </message>
    <message>
        <location filename="../plugin/toolkit/layer_styles.py" line="60"/>
        <source>kept {level} in the window</source>
        <translation>zachowane {level} w oknie</translation>
    </message>
    <message>
        <location filename="../plugin/toolkit/layer_styles.py" line="61"/>
        <source>kept {level} in the strip</source>
        <translation>zachowane {level} w pasie</translation>
    </message>
    <message>
        <location filename="../plugin/toolkit/layer_styles.py" line="62"/>
        <source>contrast {level}</source>
        <translation>kontrast {level}</translation>
    </message>
    <message>
        <location filename="../plugin/toolkit/layer_styles.py" line="63"/>
        <source>sharpness {level}</source>
        <translation>ostrość {level}</translation>
    </message>
    <message>
        <location filename="../plugin/toolkit/layer_styles.py" line="64"/>
        <source>added detail {level}</source>
        <translation>dodane detale {level}</translation>
    </message>
    <message>
        <source>the sources</source>
        <translation>ortoobrazów źródłowych</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/measure/messages.py" line="11"/>
        <source>The outline of the sheet {name} has coordinates that are not numbers; draw it again.</source>
        <translation>Obrys arkusza {name} ma współrzędne, które nie są liczbami; należy narysować go ponownie.</translation>
    </message>
    <message>
        <location filename="../plugin/imagery/messages.py" line="37"/>
        <source>{name} lies outside the area of its coordinate reference system; assign it the system of its coordinates.</source>
        <translation>{name} leży poza tym, co opisuje jego układ współrzędnych; należy mu nadać układ, w którym są jego współrzędne.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/inputs/inputs_panel.py" line="181"/>
        <source>{pixels} px, {metres} m</source>
        <translation>{pixels} px, {metres} m</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/map/window_tool.py" line="213"/>
        <source>{width} x {height} m, {columns} x {rows} px</source>
        <translation>{width} × {height} m, {columns} × {rows} px</translation>
    </message>
    <message>
        <location filename="../plugin/seams/words.py" line="202"/>
        <source>A part of the mosaic matches no source: add the missing orthoimage, unless the mosaic was altered there.</source>
        <translation>Część ortofotomapy nie pasuje do żadnego ze źródeł: dodaj brakujący ortoobraz, chyba że ortofotomapę tam zmieniono.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/words.py" line="204"/>
        <source>a part of the mosaic matches none of these sources</source>
        <translation>część ortofotomapy nie pasuje do żadnego z tych ortoobrazów źródłowych</translation>
    </message>
    <message>
        <location filename="../plugin/seams/words.py" line="205"/>
        <source>{value} % of the mosaic match none of these sources</source>
        <translation>{value} % pikseli ortofotomapy nie pasuje do żadnego z tych ortoobrazów źródłowych</translation>
    </message>
    <message>
        <location filename="../plugin/seams/window_summary.py" line="158"/>
        <source>{percent} % of the pixels match none of the given sources and are left out.</source>
        <translation>{percent} % pikseli nie pasuje do żadnego z podanych ortoobrazów i nie brało udziału.</translation>
    </message>
    <message>
        <location filename="../plugin/photos/measure/messages.py" line="12"/>
        <source>{name} has {columns} x {rows} px and no scanned photo has more than {most} along a side; choose the scan of one photo.</source>
        <translation>{name} ma {columns} x {rows} px, a żadne zeskanowane zdjęcie nie ma na boku więcej niż {most} px; wybierz skan jednego zdjęcia.</translation>
    </message>
    <message>
        <location filename="../plugin/imagery/messages.py" line="9"/>
        <source>No permission to read {name}; ask its owner for it, or for a copy.</source>
        <translation>Pliku {name} nie wolno czytać; poproś właściciela o prawo odczytu albo o kopię.</translation>
    </message>
    <message>
        <location filename="../plugin/imagery/messages.py" line="39"/>
        <source>{name} has pixels {times:.0f} times finer than the mosaic&apos;s, too many to average; resample it to them first.</source>
        <translation>{name} ma piksele {times:.0f} razy drobniejsze niż ortofotomapa, zbyt wiele do uśrednienia; najpierw należy go przepróbkować do piksela ortofotomapy.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/algorithms/calibratethreshold.py" line="51"/>
        <source>Windows that were inspected and judged: the field &apos;observer&apos; with the words &apos;visible&apos; (a loss was seen at 2x) and &apos;invisible&apos; (&apos;unsure&apos; does not count), and the measures &apos;kept_1&apos;, &apos;visibility&apos;, &apos;composite_ratio_1&apos;, &apos;contrast_1&apos; and &apos;ratio_1&apos;, as far as they exist.</source>
        <translation>Okna skontrolowane i ocenione: pole „observer” ze słowami „visible” (stratę widać przy 2×) i „invisible” („unsure” nie jest oceną) oraz miary „kept_1”, „visibility”, „composite_ratio_1”, „contrast_1” i „ratio_1”, o ile są.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/algorithms/inspectwindows.py" line="87"/>
        <source>The rectangles as measured, with their verdict, what is kept along the seam, how far an eye sees the loss at 2x (&apos;visibility&apos;, 1 is just seen), and ratios: the largest over the sources.</source>
        <translation>Prostokąty w zmierzonych granicach, z oceną, z tym, co zachowano wzdłuż linii mozaikowania, z tym, na ile oko widzi stratę w powiększeniu 2× („visibility”, 1 to strata ledwie widoczna), i ze stosunkami wariancji: największymi spośród wszystkich ortoobrazów źródłowych.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/algorithms/scanmosaic.py" line="83"/>
        <source>Each piece of seam with what it kept, the 95 % interval, the width of its band, how far an eye sees the loss at 2x, and the verdict.</source>
        <translation>Każdy odcinek linii mozaikowania z tym, co zachował, przedziałem ufności 95 %, szerokością pasa, tym, na ile oko widzi stratę w powiększeniu 2×, i oceną.</translation>
    </message>
    <message>
        <location filename="../plugin/toolkit/layer_styles.py" line="49"/>
        <source>visibility at 2x (JND)</source>
        <translation>widoczność w powiększeniu 2× (JND)</translation>
    </message>
    <message>
        <source>How many times the loss of detail along the seam exceeds what an eye just notices side by side at 2x: just noticeable differences of contrast, by the sensitivity of the eye to the size and contrast of the detail.</source>
        <translation>Ile razy więcej detali utracono wzdłuż linii mozaikowania, niż oko ledwie dostrzega obok siebie w powiększeniu 2×: ledwie zauważalne różnice kontrastu, według czułości oka na wielkość i kontrast detali.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/report/flagged_windows.py" line="74"/>
        <source>visibility at 2x (JND): {value:.1f}</source>
        <translation>widoczność w powiększeniu 2× (JND): {value:.1f}</translation>
    </message>
    <message>
        <location filename="../plugin/seams/words.py" line="131"/>
        <source>blur took {value} %</source>
        <translation>rozmycie zabrało {value} %</translation>
    </message>
    <message>
        <location filename="../plugin/seams/words.py" line="143"/>
        <source>other mixture</source>
        <translation>inna mieszanina</translation>
    </message>
    <message>
        <location filename="../plugin/seams/words.py" line="144"/>
        <source>Images were mixed along the seam, but not by weights: by the darker pixel, at random, by hand.</source>
        <translation>Wzdłuż linii mozaikowania zmieszano obrazy, ale nie wagami: według ciemniejszego piksela, losowo, ręcznie.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/words.py" line="179"/>
        <source>clipping took {value} %</source>
        <translation>obcięcie zabrało {value} %</translation>
    </message>
    <message>
        <location filename="../plugin/seams/words.py" line="192"/>
        <source>Images that meet in the mosaic do not line up there.</source>
        <translation>Obrazy, które stykają się w ortofotomapie, nie leżą tam na sobie.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/words.py" line="217"/>
        <source>resampling took {value} %</source>
        <translation>przepróbkowanie zabrało {value} %</translation>
    </message>
    <message>
        <location filename="../plugin/seams/words.py" line="236"/>
        <source>compression took {value} %</source>
        <translation>kompresja zabrała {value} %</translation>
    </message>
    <message>
        <location filename="../plugin/seams/words.py" line="145"/>
        <source>images are mixed by another rule than weights</source>
        <translation>obrazy są zmieszane inaczej niż wagami</translation>
    </message>
    <message>
        <location filename="../plugin/seams/words.py" line="193"/>
        <source>images do not fit where they meet</source>
        <translation>obrazy nie pasują do siebie tam, gdzie się stykają</translation>
    </message>
    <message>
        <location filename="../plugin/seams/words.py" line="194"/>
        <source>images lie {value} px apart where they meet</source>
        <translation>obrazy są odsunięte od siebie o {value} px tam, gdzie się stykają</translation>
    </message>
    <message>
        <location filename="../plugin/seams/words.py" line="273"/>
        <source>the cause is unclear</source>
        <translation>przyczyna jest niejasna</translation>
    </message>
    <message>
        <location filename="../plugin/seams/charts/profile_painter.py" line="261"/>
        <source>share of the other image</source>
        <translation>udział drugiego obrazu</translation>
    </message>
    <message>
        <location filename="../plugin/seams/charts/profile_painter.py" line="263"/>
        <source>other image</source>
        <translation>drugi obraz</translation>
    </message>
    <message>
        <location filename="../plugin/seams/measure/messages.py" line="97"/>
        <source>It is unclear whether the loss is significant, as {low:.0f} to {high:.0f} % may be left; measure more of the seam, or judge it by eye.</source>
        <translation>Nie da się powiedzieć, czy strata jest istotna, gdyż mogło zostać od {low:.0f} do {high:.0f} %; zmierz dłuższy odcinek linii mozaikowania albo obejrzyj ją.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/window_summary.py" line="333"/>
        <source>The whole window has {percent} % of the sharpness of its sources.</source>
        <translation>Całe okno ma {percent} % ostrości ortoobrazów źródłowych.</translation>
    </message>
    <message>
        <location filename="../plugin/toolkit/layer_styles.py" line="48"/>
        <source>width of the feather (m)</source>
        <translation>szerokość wtapiania (m)</translation>
    </message>
    <message>
        <location filename="../plugin/seams/measure/window/window_tables.py" line="120"/>
        <source>images apart in the mosaic (px)</source>
        <translation>odsunięcie obrazów w ortofotomapie (px)</translation>
    </message>
    <message>
        <location filename="../plugin/seams/words.py" line="137"/>
        <source>Two images that differ were mixed by weights along the seam.</source>
        <translation>Wzdłuż linii mozaikowania zmieszano wagami dwa obrazy, które się różnią.</translation>
    </message>
    <message>
        <source>The share of the detail that is kept by distance from the seam, with its 95 % interval; where level 1 drops below the dashed line, the loss is significant. The dotted line is the share of the image beyond the seam in the mixture of the two.</source>
        <translation>Część zachowanych detali w zależności od odległości od linii mozaikowania, z 95 % przedziałem ufności; gdzie poziom 1 opada poniżej linii przerywanej, strata jest istotna. Linia kropkowana to udział obrazu zza linii mozaikowania w mieszaninie obu.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/window_summary.py" line="328"/>
        <source>In the whole window {left} % of the finest detail is left (sharpness {sharpness} %): {took}.</source>
        <translation>W całym oknie zostało {left} % najdrobniejszych detali (ostrość {sharpness} %): {took}.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/window_summary.py" line="327"/>
        <source>the seam took {value} %</source>
        <translation>łączenie wzdłuż linii mozaikowania zabrało {value} %</translation>
    </message>
    <message>
        <location filename="../plugin/seams/measure/messages.py" line="113"/>
        <source>No seam cell names a source that is given, so the cells say nothing; the first one names &apos;{name}&apos;.</source>
        <translation>Żaden poligon linii mozaikowania nie wskazuje podanego ortoobrazu źródłowego, więc poligony nic nie mówią; pierwszy wskazuje „{name}”.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/measure/messages.py" line="231"/>
        <source>No seamlines can be read from {path}; check that it is a vector file, and the name of its layer.</source>
        <translation>Nie można odczytać linii mozaikowania z {path}; sprawdź, czy to plik wektorowy, i nazwę jego warstwy.</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/measure/messages.py" line="169"/>
        <source>The orthoimage is up to {most:.1f} px off the exact model, since an RPC approximates it.</source>
        <translation>Ortoobraz leży do {most:.1f} px od miejsca, w którym widzi go dokładny model, bo model zastępuje RPC.</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/measure/messages.py" line="174"/>
        <source>The distortion of the camera is not valid at a part of the photo&apos;s edge; check its coefficients and the size of the image that they belong to.</source>
        <translation>Dystorsja kamery nie daje żadnego promienia na części brzegu zdjęcia; sprawdź jej współczynniki i rozmiar obrazu, do którego należą.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/measure/messages.py" line="277"/>
        <source>While the mosaic was scanned {name} changed, so what was read of it before can&apos;t be used; start the scan again with the same output, and it is measured again.</source>
        <translation>Podczas badania ortofotomapy zmienił się plik {name}, więc tego, co odczytano z niego wcześniej, nie można użyć; uruchom badanie ortofotomapy ponownie z tym samym wynikiem, a zostanie zmierzony od nowa.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/measure/messages.py" line="299"/>
        <source>No seam was found: as far as the orthoimages explain the mosaic, all of it shows {name}.</source>
        <translation>Nie znaleziono linii mozaikowania: w zakresie, w jakim ortoobrazy wyjaśniają ortofotomapę, cała pochodzi z {name}.</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/acceptmosaic.py" line="156"/>
        <source>Share of the seams on ground with detail. If less was measured, a delivery is not accepted.</source>
        <translation>Linii mozaikowania w terenie z detalami. Gdy zmierzono mniej, dostawa nie jest przyjmowana.</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/acceptmosaic.py" line="74"/>
        <source>accepted, rejected or undecided</source>
        <translation>przyjęto, odrzucono lub nie rozstrzygnięto</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/acceptmosaic.py" line="77"/>
        <source>Accepted (1), rejected (0), or empty if undecided</source>
        <translation>Przyjęto (1), odrzucono (0) lub puste, gdy nie rozstrzygnięto</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/checkdelivery.py" line="35"/>
        <source>Check a delivery</source>
        <translation>Sprawdź dostawę</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/checkdelivery.py" line="45"/>
        <source>Folder of the delivered sheets. Empty: the files named in the sheets&apos; field location.</source>
        <translation>Katalog dostarczonych arkuszy. Puste: pliki, które wymienia pole location arkuszy.</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/checkdelivery.py" line="48"/>
        <source>Outlines of the sheets that were ordered, as polygons with a field sheet, name or location. Empty: all files in the folder count as ordered, and only their form is checked.</source>
        <translation>Obrysy zamówionych arkuszy jako poligony z polem sheet, name lub location. Puste: zamówiono to, co zawiera katalog, i sprawdzana jest tylko postać plików.</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/checkdelivery.py" line="52"/>
        <source>The pattern of file names, with * and ?, such as ortho_????_??.tif. Empty: any name.</source>
        <translation>Jak mają się nazywać pliki, ze znakami * i ?, np. ortho_????_??.tif. Puste: dowolnie.</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/checkdelivery.py" line="61"/>
        <source>Number of bands without alpha. Empty: that of most sheets.</source>
        <translation>Ile, bez kanału alfa. Puste: tyle, ile w większości arkuszy.</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/checkdelivery.py" line="67"/>
        <source>Share of a sheet&apos;s outline.</source>
        <translation>Obrysu arkusza.</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/checkdelivery.py" line="70"/>
        <source>Each sheet with its file, its findings, and whether it has none.</source>
        <translation>Każdy arkusz z jego plikiem, uwagami i informacją, czy uwag nie ma.</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/checkdelivery.py" line="44"/>
        <source>Folder</source>
        <translation>Katalog</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/checkdelivery.py" line="51"/>
        <source>Pattern of names</source>
        <translation>Wzorzec nazw</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/checkdelivery.py" line="60"/>
        <source>Bands</source>
        <translation>Kanały</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/checkdelivery.py" line="63"/>
        <source>Type of the pixels</source>
        <translation>Typ pikseli</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/checkdelivery.py" line="66"/>
        <source>Largest share without data (%)</source>
        <translation>Największy udział bez danych (%)</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/checkdelivery.py" line="69"/>
        <source>Checked sheets</source>
        <translation>Sprawdzone arkusze</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/checkdelivery.py" line="72"/>
        <source>Mosaic of all sheets</source>
        <translation>Ortofotomapa wszystkich arkuszy</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/checkdelivery.py" line="77"/>
        <source>Number of sheets</source>
        <translation>Liczba arkuszy</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/checkdelivery.py" line="78"/>
        <source>Sheets without a file</source>
        <translation>Arkusze bez pliku</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/checkdelivery.py" line="79"/>
        <source>Sheets with findings</source>
        <translation>Arkusze z uwagami</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/checkdelivery.py" line="80"/>
        <source>Complete (1) or not (0)</source>
        <translation>Kompletna (1) lub nie (0)</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/measure/messages.py" line="63"/>
        <source>{value:.2%} of the measured metres failed, {limit:.2%} is allowed; with what is unknown it may be {low:.2%} to {high:.2%}</source>
        <translation>niezgodnych jest {value:.2%} zmierzonych metrów, a dopuszcza się {limit:.2%}, lecz wobec tego, czego nie wiadomo, może to być od {low:.2%} do {high:.2%}</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/measure/messages.py" line="98"/>
        <source>{metres:.0f} m of seam are missing</source>
        <translation>w warstwach brakuje {metres:.0f} m linii mozaikowania</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/measure/messages.py" line="132"/>
        <source>{metres:.0f} of {all:.0f} m of seam lie on ground without detail, which has nothing to lose; they are not judged.</source>
        <translation>{metres:.0f} z {all:.0f} m linii mozaikowania leży w terenie bez detali, który nie ma czego stracić; nie są one częścią tego, co się ocenia.</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/measure/messages.py" line="157"/>
        <source>What would decide it: the layers of the whole scan, not a sample of their pieces.</source>
        <translation>Co by rozstrzygnęło: warstwy całego skanowania, a nie próba ich odcinków.</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/measure/messages.py" line="187"/>
        <source>The layers of seams are as their scans left them ({count}).</source>
        <translation>Warstwy linii mozaikowania są takie, jak zostawiło je skanowanie ({count}).</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/measure/messages.py" line="197"/>
        <source>{name} is filtered ({filter}) and shows only a part of its seams; remove the filter, as the decision needs all of them.</source>
        <translation>Warstwa {name} jest filtrowana ({filter}) i pokazuje część linii mozaikowania; usuń filtr, bo decyzja dotyczy wszystkich.</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/measure/messages.py" line="247"/>
        <source>Neither a folder nor sheets are given; choose the folder of the delivery, or its index.</source>
        <translation>Nie podano ani katalogu, ani arkuszy; wskaż, gdzie leży dostawa, lub jej indeks.</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/measure/messages.py" line="248"/>
        <source>{folder} holds no rasters and no sheets are given; choose the folder of the delivery.</source>
        <translation>{folder} nie zawiera rastrów i nie podano arkuszy; wskaż katalog dostawy.</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/measure/messages.py" line="249"/>
        <source>The check was stopped; nothing is written.</source>
        <translation>Kontrolę przerwano; nic nie zapisano.</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/measure/messages.py" line="250"/>
        <source>{sheet}: {finding}.</source>
        <translation>{sheet}: {finding}.</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/measure/messages.py" line="251"/>
        <source>Sheets: {count}, with findings: {faulty}, of these without a file: {missing}.</source>
        <translation>Arkusze: {count}, z uwagami: {faulty}, w tym bez pliku: {missing}.</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/measure/messages.py" line="252"/>
        <source>{path} can&apos;t be written; choose another folder.</source>
        <translation>Nie można zapisać {path}; wybierz inny katalog.</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/measure/messages.py" line="253"/>
        <source>the file is missing</source>
        <translation>brakuje pliku</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/measure/messages.py" line="254"/>
        <source>it was not ordered</source>
        <translation>nikt go nie zamówił</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/measure/messages.py" line="255"/>
        <source>the file is not georeferenced</source>
        <translation>plik nie mówi, gdzie leży</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/measure/messages.py" line="256"/>
        <source>its name {name} does not match {pattern}</source>
        <translation>nazwa {name} nie odpowiada wzorcowi {pattern}</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/measure/messages.py" line="259"/>
        <source>it has {bands} bands instead of {wanted}</source>
        <translation>liczba kanałów to {bands} zamiast {wanted}</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/measure/messages.py" line="260"/>
        <source>its pixels are {kind} instead of {wanted}</source>
        <translation>piksele są typu {kind} zamiast {wanted}</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/measure/messages.py" line="261"/>
        <source>{share:.2%} of its outline has no data</source>
        <translation>{share:.2%} obrysu nie ma danych</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/measure/messages.py" line="264"/>
        <source>it is unknown whether it has data everywhere</source>
        <translation>nie da się stwierdzić, czy wszędzie ma dane</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/paper/words.py" line="124"/>
        <source>No seams</source>
        <translation>Bez linii</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/paper/acceptance_report.py" line="255"/>
        <source>ground without detail</source>
        <translation>teren bez detali</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/paper/acceptance_report.py" line="343"/>
        <source>Orthoimage {name}</source>
        <translation>Ortoobraz {name}</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/paper/acceptance_report.py" line="144"/>
        <source>sheets with findings: {count} of {all}</source>
        <translation>arkusze z uwagami: {count} z {all}</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/paper/acceptance_report.py" line="174"/>
        <source>With findings</source>
        <translation>Z uwagami</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/paper/acceptance_report.py" line="145"/>
        <source>No findings</source>
        <translation>Bez uwag</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/paper/acceptance_report.py" line="149"/>
        <source>radiometry</source>
        <translation>radiometria</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/paper/acceptance_report.py" line="149"/>
        <source>Not checked</source>
        <translation>Nie sprawdzono</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/paper/acceptance_report.py" line="149"/>
        <source>&apos;Check radiometry&apos; checks it</source>
        <translation>sprawdza to „Sprawdź radiometrię”</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/paper/acceptance_report.py" line="142"/>
        <source>completeness and form of the files</source>
        <translation>kompletność i postać plików</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/paper/acceptance_report.py" line="148"/>
        <source>&apos;Check a delivery&apos; checks it</source>
        <translation>sprawdza to „Sprawdź dostawę”</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/paper/acceptance_report.py" line="320"/>
        <source>The mosaic</source>
        <translation>Ortofotomapa</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/paper/acceptance_report.py" line="320"/>
        <source>Its orthoimages, cut hard</source>
        <translation>Jej ortoobrazy cięte ostro</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/paper/acceptance_report.py" line="263"/>
        <source>sheet: {verdict}</source>
        <translation>arkusz: {verdict}</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/paper/paper_head.py" line="17"/>
        <source>Title of the report; empty: Acceptance of an orthophoto mosaic.</source>
        <translation>Raportu; puste: Odbiór ortofotomapy.</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/paper/paper_head.py" line="18"/>
        <source>Contract</source>
        <translation>Umowa</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/paper/paper_head.py" line="18"/>
        <source>Number of the order or contract that the delivery belongs to.</source>
        <translation>Numer zamówienia lub umowy, do której należy dostawa.</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/paper/paper_head.py" line="19"/>
        <source>Producer</source>
        <translation>Wykonawca</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/paper/paper_head.py" line="19"/>
        <source>Who made the delivery.</source>
        <translation>Kto wykonał dostawę.</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/paper/paper_head.py" line="20"/>
        <source>Client</source>
        <translation>Zamawiający</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/paper/paper_head.py" line="20"/>
        <source>Who ordered the delivery and decides on it.</source>
        <translation>Kto zamówił dostawę i o niej decyduje.</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/paper/paper_head.py" line="21"/>
        <source>Delivery</source>
        <translation>Dostawa</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/paper/paper_head.py" line="21"/>
        <source>What the delivery is called.</source>
        <translation>Nazwa dostawy.</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/paper/paper_head.py" line="22"/>
        <source>Date of the delivery</source>
        <translation>Data dostawy</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/paper/words.py" line="49"/>
        <source>Length of seam that could be measured, divided by the length of all seams on ground with detail.</source>
        <translation>Długość linii mozaikowania, którą dało się zmierzyć, do długości wszystkich linii mozaikowania w terenie z detalami.</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/paper/words.py" line="55"/>
        <source>Accepted</source>
        <translation>Przyjęto</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/paper/words.py" line="56"/>
        <source>Rejected</source>
        <translation>Odrzucono</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/paper/words.py" line="57"/>
        <source>Undecided</source>
        <translation>Nie rozstrzygnięto</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/paper/paper_head.py" line="66"/>
        <source>One polygon for each sheet, with its verdict by the same limits and its metres.</source>
        <translation>Jeden poligon na każdy arkusz, z oceną według tych samych granic i z metrami.</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/paper/outputs.py" line="62"/>
        <source>Decided sheets</source>
        <translation>Ocenione arkusze</translation>
    </message>
    <message>
        <location filename="../plugin/seams/algorithms/scanmosaic.py" line="94"/>
        <source>Length of the pieces that keep less than 70 % (metres)</source>
        <translation>Długość odcinków, które zachowują mniej niż 70 % (metry)</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/dock.py" line="210"/>
        <source>Accept...</source>
        <translation>Odbiór...</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/inputs/inputs_panel.py" line="184"/>
        <source>few windows below {pixels} px can be measured</source>
        <translation>niewiele okien mniejszych niż {pixels} px daje się zmierzyć</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/judge_bar.py" line="52"/>
        <source>Why?</source>
        <translation>Dlaczego?</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/judge_bar.py" line="55"/>
        <source>What the sentence is based on: intervals, what an eye sees, all causes with their figures, the paper&apos;s rule.</source>
        <translation>Na czym opiera się to zdanie: przedziały, co widzi oko, wszystkie przyczyny z liczbami, reguła z publikacji.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/measure/messages.py" line="72"/>
        <source>No change from one source to another is found in the window; the verdict is based on sharpness alone.</source>
        <translation>W oknie nie znaleziono przejścia z jednego źródła na drugie; ocena opiera się na samej ostrości.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/measure/messages.py" line="258"/>
        <source>Only {between:.0f} of {all:.0f} m of the seamlines lie on two of the given orthoimages or more, so the seams are measured as without orthoimages; give those that are missing.</source>
        <translation>Tylko {between:.0f} z {all:.0f} m linii mozaikowania leży na co najmniej dwóch z podanych ortoobrazów, więc linie zmierzono jak bez ortoobrazów; podaj brakujące.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/measure/messages.py" line="262"/>
        <source>Names of orthoimages in the seamline layer that fit several of those given: {count} (such as {names}). Borders of polygons with such a name stay seams, and the pixels decide what the mosaic shows there; write paths with their folders into the layer to tell them apart.</source>
        <translation>Nazwy ortoobrazów w warstwie linii mozaikowania pasują do kilku podanych: {count} (przede wszystkim {names}). Granice poligonów o takiej nazwie pozostają liniami mozaikowania, a to, któremu ortoobrazowi odpowiada tam ortofotomapa, mówi ona sama; aby je rozróżnić, wpisz do warstwy ścieżki z katalogami.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/measure/messages.py" line="312"/>
        <source>The ground along this piece has no fine detail that could be lost: the orthoimages show hardly more than noise there. It does not count.</source>
        <translation>Teren wzdłuż tego odcinka nie ma drobnych detali, które można by stracić: ortoobrazy pokazują tam niewiele więcej niż szum. Odcinek się nie liczy.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/measure/window/window_tables.py" line="125"/>
        <source>loss (m2)</source>
        <translation>strata (m2)</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/windows/window_columns.py" line="113"/>
        <source>loss</source>
        <translation>strata</translation>
    </message>
    <message>
        <location filename="../plugin/seams/window_summary.py" line="59"/>
        <source>{area} m²</source>
        <translation>{area} m²</translation>
    </message>
    <message>
        <location filename="../plugin/seams/window_summary.py" line="303"/>
        <source>Along the seam {kept} % is left of the finest detail around it ({low} to {high} %).</source>
        <translation>Wzdłuż linii mozaikowania zostało {kept} % najdrobniejszych detali z otoczenia ({low} do {high} %).</translation>
    </message>
    <message>
        <location filename="../plugin/seams/window_summary.py" line="306"/>
        <source>The loss along the seam lies between {least} and {most} % (95 % interval).</source>
        <translation>Strata wzdłuż linii mozaikowania wynosi od {least} do {most} %, z prawdopodobieństwem 95 %.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/window_summary.py" line="309"/>
        <source>It is {times} times what an eye just sees at 2x.</source>
        <translation>To {times} razy tyle, ile oko ledwo dostrzega przy powiększeniu 2x.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/window_summary.py" line="332"/>
        <source>The window is as sharp as its sources.</source>
        <translation>Okno jest tak ostre jak jego źródła.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/window_summary.py" line="45"/>
        <source>loss: {area}</source>
        <translation>strata: {area}</translation>
    </message>
    <message>
        <location filename="../plugin/seams/words.py" line="238"/>
        <source>Compress it less.</source>
        <translation>Zastosuj słabszą kompresję.</translation>
    </message>
    <message>
        <location filename="../plugin/toolkit/layer_styles.py" line="32"/>
        <source>piece or stretch</source>
        <translation>odcinek czy ciąg odcinków</translation>
    </message>
    <message>
        <location filename="../plugin/toolkit/layer_styles.py" line="33"/>
        <source>counts as</source>
        <translation>liczy się jako</translation>
    </message>
    <message>
        <source>part of the delivery</source>
        <translation>część dostawy</translation>
    </message>
    <message>
        <source>in figures</source>
        <translation>w liczbach</translation>
    </message>
    <message>
        <source>The seams</source>
        <translation>Linie mozaikowania</translation>
    </message>
    <message>
        <source>The seams of all sheets, none of which failed.</source>
        <translation>Linie mozaikowania wszystkich arkuszy; żadna nie jest niezgodna.</translation>
    </message>
    <message>
        <source>What the figures rest on</source>
        <translation>Na czym opierają się liczby</translation>
    </message>
    <message>
        <source>Each sheet is judged by the limits of the delivery.</source>
        <translation>Ocena arkusza opiera się na granicach przyjętych dla dostawy.</translation>
    </message>
    <message>
        <source>Findings in the files</source>
        <translation>Uwagi do plików</translation>
    </message>
    <message>
        <source>No failures</source>
        <translation>Brak usterek</translation>
    </message>
    <message>
        <source>No piece of seam that was measured failed.</source>
        <translation>Żaden zmierzony odcinek linii mozaikowania nie jest niezgodny.</translation>
    </message>
    <message>
        <source>visible loss</source>
        <translation>widoczna strata</translation>
    </message>
    <message>
        <source>standards</source>
        <translation>normy</translation>
    </message>
    <message>
        <source>Annex: orthoimages</source>
        <translation>Załącznik: ortoobrazy</translation>
    </message>
    <message>
        <source>taken on</source>
        <translation>data wykonania</translation>
    </message>
    <message>
        <source>One feature for each failure without a break, for the producer.</source>
        <translation>Jeden obiekt na każdą nieprzerwaną usterkę, dla wykonawcy.</translation>
    </message>
    <message>
        <source>The decision on paper, to be signed.</source>
        <translation>Decyzja na papierze, do podpisu.</translation>
    </message>
    <message>
        <source>The detail that is kept, cell by cell.</source>
        <translation>Jakie szczegóły zachowano, komórka po komórce.</translation>
    </message>
    <message>
        <source>Each piece of seam with what it kept and the verdict.</source>
        <translation>Każdy odcinek linii mozaikowania z tym, co zachował, i z oceną.</translation>
    </message>
    <message>
        <source>Windows that kept least, the worst first.</source>
        <translation>Okna, w których zachowano najmniej, od najgorszego.</translation>
    </message>
    <message>
        <source>Lines, or polygons that are each filled from one orthoimage. Needed where there are no orthoimages.</source>
        <translation>Linie albo poligony, z których każdy wypełniono z jednego ortoobrazu. Konieczne, gdy nie ma ortoobrazów.</translation>
    </message>
    <message>
        <source>Accept delivery</source>
        <translation>Odbiór dostawy od plików</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/acceptmosaic.py" line="42"/>
        <source>Decides on a delivery from the seams of one scan or of many sheets: how many metres failed, how long without a break, and whether rules or a plan of ISO 2859 accept it, reject it or can&apos;t decide, and then what would decide it. A piece of seam fails when it kept less than required; metres are sums of whole pieces. What could not be measured never counts as passed.</source>
        <translation>Rozstrzyga o dostawie na podstawie linii mozaikowania z jednego skanowania lub z wielu arkuszy: ile metrów jest niezgodnych, jak długo bez przerwy, i według reguł lub planu ISO 2859, czy dostawę się przyjmuje, odrzuca, czy nie da się rozstrzygnąć, i co by wtedy rozstrzygnęło. Odcinek jest niezgodny, gdy zachował mniej, niż się wymaga; metry są sumami całych odcinków. Co nie dało się zmierzyć, nigdy nie liczy się jako zgodne.</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/acceptmosaic.py" line="57"/>
        <source>all: by the metres of all seams and the limits above. iso2859: by the number of failing pieces in a random sample, as ISO 2859-1 plans it for the lots of a series. iso2859_2: the same for a single delivery, an isolated lot, by its limiting quality (ISO 2859-2).</source>
        <translation>all: według metrów wszystkich linii mozaikowania i powyższych granic. iso2859: według liczby niezgodnych odcinków w próbie losowej, zgodnie z planem ISO 2859-1 dla partii w serii. iso2859_2: tak samo dla pojedynczej dostawy, czyli partii izolowanej, według jakości granicznej (ISO 2859-2).</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/measure/messages.py" line="24"/>
        <source>{place} in {name}: the {key} &apos;{value}&apos; is not in the standard; known are {known}.</source>
        <translation>{place} w {name}: {key} „{value}” nie występuje w normie; dostępne są: {known}.</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/measure/messages.py" line="40"/>
        <source>{size} of {lot} pieces are inspected and up to {acceptance} may fail ({plan}).</source>
        <translation>Kontrolowane odcinki: {size} z {lot}, niezgodnych może być najwyżej {acceptance} ({plan}).</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/measure/messages.py" line="126"/>
        <source>{standard}, all of the lot of {lot} inspected</source>
        <translation>{standard}, skontrolowano całą partię o liczności {lot}</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/stated_rules.py" line="116"/>
        <source>The percentage of failing pieces with which an isolated lot should hardly ever be accepted, by ISO 2859-2: at least three times the percentage that you want.</source>
        <translation>Odsetek niezgodnych odcinków, przy którym partia izolowana powinna być przyjmowana bardzo rzadko, zgodnie z ISO 2859-2: co najmniej trzykrotność tego, czego oczekujesz.</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/stated_rules.py" line="115"/>
        <source>Limiting quality (LQ)</source>
        <translation>Jakość graniczna (LQ)</translation>
    </message>
    <message>
        <location filename="../plugin/noise/checknoise.py" line="40"/>
        <source>Measures how much random noise an image has, from film, scanner or sensor. In an image with little noise the relative variance of the details rises from level to level; noise lifts level 1 above level 2 (moderate) and, where it is strong, level 2 above level 3 (Pyka 2009). Grain coarser than a pixel is looked for in the spectrum of the quietest ground; where texture could hide it, the verdict is uncertain. The rule compares noise with the scene; the amount beside it is the ratio of the signal to the noise. Photographs and scans need no georeference. Two groups of images, of another camera, film or process, are compared; where they show the same ground each window is measured on both, with the same pixels left out. Windows are grouped by one of their fields, such as land use or scale.</source>
        <translation>Mówi, ile szumu losowego ma obraz, czy to film, skan, czy matryca. W obrazie o małym szumie wariancja względna detali rośnie z poziomu na poziom; szum podnosi poziom 1 ponad poziom 2 (umiarkowany), a gdy jest silny, poziom 2 ponad poziom 3 (Pyka 2009). Ziarna grubszego niż piksel szuka się w widmie najspokojniejszego terenu; gdzie tekstura mogłaby je ukryć, ocena jest niepewna. Reguła porównuje szum ze sceną; ilość podana obok to stosunek sygnału do szumu. Zdjęcia i skany nie muszą leżeć na mapie. Porównuje się dwie grupy obrazów, z innej kamery, filmu lub procesu; gdzie pokazują ten sam teren, każde okno mierzy się na obu, z pominięciem tych samych pikseli. Okna grupuje się według ich pola, na przykład użytkowania terenu lub skali.</translation>
    </message>
    <message>
        <location filename="../plugin/noise/noise_summary.py" line="31"/>
        <source>little</source>
        <translation>mały</translation>
    </message>
    <message>
        <location filename="../plugin/noise/noise_summary.py" line="32"/>
        <source>some</source>
        <translation>umiarkowany</translation>
    </message>
    <message>
        <location filename="../plugin/noise/noise_summary.py" line="33"/>
        <source>much</source>
        <translation>duży</translation>
    </message>
    <message>
        <location filename="../plugin/noise/report.py" line="139"/>
        <source>amount</source>
        <translation>poziom szumu</translation>
    </message>
    <message>
        <location filename="../plugin/radiometry/words.py" line="116"/>
        <source>The rules set no limit for it.</source>
        <translation>Reguły nie zawierają granicy, względem której można by go ocenić.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/algorithms/mendseams.py" line="38"/>
        <source>Mend seams</source>
        <translation>Napraw linie mozaikowania</translation>
    </message>
    <message>
        <location filename="../plugin/seams/algorithms/mendseams.py" line="40"/>
        <source>Cuts failed seams anew. Each new cut runs where the two orthoimages agree, around roofs, cars and trees that they show in different places. Its pixels come from the orthoimages in the mosaic&apos;s own tones and sharpness, and only tones are blended more widely. Patches and a virtual mosaic are written; the mosaic itself is never touched. Then the new cuts are measured as in a scan, and only those that keep more detail than before are used. Where the orthoimages do not fit anywhere, the seam stays as it is and the table gives the reason.</source>
        <translation>Tnie na nowo linie mozaikowania z usterkami. Nowe cięcie biegnie tam, gdzie oba ortoobrazy są zgodne, wokół dachów, samochodów i drzew, które pokazują w różnych miejscach. Piksele pochodzą z ortoobrazów w tonach i ostrości ortofotomapy; łagodzone są tylko tony. Zapisywane są łaty i wirtualna ortofotomapa, a sama ortofotomapa nie jest zmieniana. Potem nowe cięcia są mierzone tak jak w skanowaniu i zostaje tylko to, co zachowuje więcej detali niż przedtem. Gdzie ortoobrazy nigdzie do siebie nie pasują, linia pozostaje bez zmian, a przyczyna jest podana.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/algorithms/mendseams.py" line="50"/>
        <source>All seams as Scan a whole mosaic writes them. Or windows: then the mosaic is scanned first, and the seams in the windows are mended.</source>
        <translation>Wszystkie linie mozaikowania, jak zapisuje je skanowanie całej ortofotomapy. Albo okna: wtedy ortofotomapa jest najpierw skanowana, a naprawiane są linie w oknach.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/algorithms/mendseams.py" line="54"/>
        <source>failed: pieces that keep less than 70 %. reduced: also those that measurably lost some detail. all: every piece.</source>
        <translation>failed: odcinki, które zachowują mniej niż 70 %. reduced: także te, które mierzalnie straciły detale. all: wszystkie odcinki.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/algorithms/mendseams.py" line="58"/>
        <source>How far a new cut may move to either side of the seam; at most 800 pixels.</source>
        <translation>Jak daleko nowe cięcie może odejść w każdą stronę od linii mozaikowania; najwyżej 800 pikseli.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/algorithms/mendseams.py" line="61"/>
        <source>Width over which the two orthoimages are mixed at the cut. 0: a hard cut.</source>
        <translation>Szerokość, na której oba ortoobrazy są mieszane przy cięciu. 0: twarde cięcie.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/algorithms/mendseams.py" line="68"/>
        <source>A virtual raster: the mosaic with the patches on top. It refers to both, so leave both there.</source>
        <translation>Raster wirtualny: ortofotomapa, a nad nią łaty. Jedne i drugie muszą pozostać na swoich miejscach.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/algorithms/mendseams.py" line="71"/>
        <source>Each seam as it runs now, with what it kept before and after, and its step of tone before and after.</source>
        <translation>Każda linia mozaikowania w nowym przebiegu, z tym, co zachowywała przed i po, oraz ze skokiem tonu przed i po.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/algorithms/mendseams.py" line="53"/>
        <source>What to mend</source>
        <translation>Co naprawić</translation>
    </message>
    <message>
        <location filename="../plugin/seams/algorithms/mendseams.py" line="57"/>
        <source>Width of the corridor (metres)</source>
        <translation>Szerokość korytarza (metry)</translation>
    </message>
    <message>
        <location filename="../plugin/seams/algorithms/mendseams.py" line="60"/>
        <source>Blend (pixels)</source>
        <translation>Wtapianie (piksele)</translation>
    </message>
    <message>
        <location filename="../plugin/seams/algorithms/mendseams.py" line="64"/>
        <source>Patches</source>
        <translation>Łaty</translation>
    </message>
    <message>
        <location filename="../plugin/seams/algorithms/mendseams.py" line="67"/>
        <source>Mended mosaic</source>
        <translation>Naprawiona ortofotomapa</translation>
    </message>
    <message>
        <location filename="../plugin/seams/algorithms/mendseams.py" line="70"/>
        <source>Cuts</source>
        <translation>Cięcia</translation>
    </message>
    <message>
        <location filename="../plugin/seams/algorithms/mendseams.py" line="76"/>
        <source>Length of the seams that are mended (metres)</source>
        <translation>Długość naprawionych linii mozaikowania (metry)</translation>
    </message>
    <message>
        <location filename="../plugin/seams/algorithms/mendseams.py" line="77"/>
        <source>Length of the seams that stay as they were (metres)</source>
        <translation>Długość linii mozaikowania, które pozostały bez zmian (metry)</translation>
    </message>
    <message>
        <location filename="../plugin/seams/algorithms/predictloss.py" line="53"/>
        <source>Full width, from where only one image counts to where only the other does. What such a feather would leave in the whole window and in its own strip is in window_kept and strip_kept. 0 or empty: only the middle of the feather is predicted, where both images weigh the same.</source>
        <translation>Pełna szerokość, od miejsca, gdzie jest tylko jeden obraz, do miejsca, gdzie jest tylko drugi. Ile takie wtapianie zostawiłoby w całym oknie i w samym pasie, podają window_kept i strip_kept. 0 lub puste: prognoza dotyczy tylko środka pasa, gdzie oba obrazy mają równe wagi.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/algorithms/predictloss.py" line="63"/>
        <source>Lines along which the images are to be joined, or polygons with such borders, where they are known. Elsewhere the seam is assumed to run straight through the middle of its window, and the prediction is the mean over the directions it may have.</source>
        <translation>Linie, wzdłuż których obrazy mają być łączone, albo poligony o takich granicach, jeśli są znane. Gdzie indziej zakłada się, że linia mozaikowania biegnie prosto przez środek okna, a prognoza jest średnią z kierunków, które może mieć.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/algorithms/scanmosaic.py" line="42"/>
        <source>Measures a whole mosaic in one pass: a picture of where detail was lost, every piece of its seams with what it kept, which orthoimage each part came from, and windows of the worst places, ready to be judged in the desk. Seams are found from the pixels, or taken from the seamlines that are given. A scan that was stopped for any reason continues when it is started again with the same output.</source>
        <translation>Mierzy całą ortofotomapę w jednym przebiegu: tworzy obraz miejsc, w których utracono detale, każdy odcinek linii mozaikowania z tym, co zachował, informację, z którego ortoobrazu pochodzi każda część, oraz okna najgorszych miejsc, gotowe do oceny w panelu. Linie mozaikowania są znajdowane na podstawie pikseli albo brane z podanej warstwy. Badanie przerwane w jakikolwiek sposób i uruchomione ponownie z tym samym plikiem wyniku jest kontynuowane od miejsca przerwania.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/algorithms/scanmosaic.py" line="90"/>
        <source>Windows that kept least, the worst first, ready for the desk and for Inspect windows.</source>
        <translation>Okna w miejscach, gdzie zachowano najmniej, zaczynając od najgorszych, gotowe do użycia w panelu i w algorytmie „Skontroluj okna”.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/inputs/sources.py" line="269"/>
        <source>The orthoimages that the mosaic was made from. The reason stands beside each one that is left out; tick it to use it anyway. Untick a missing one to remove it from the inputs.</source>
        <translation>Ortoobrazy, z których powstała ortofotomapa. Przy pominiętym podano powód; zaznacz go, aby mimo to go użyć. Odznacz brakujący, aby usunąć go z danych wejściowych.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/measure/messages.py" line="403"/>
        <source>Both orthoimages cover too little of the corridor for a cut from one end to the other; make it wider.</source>
        <translation>Oba ortoobrazy mają piksele w zbyt małej części korytarza, by ciąć od końca do końca; poszerz go.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/measure/messages.py" line="406"/>
        <source>The two orthoimages lie {misfit:.1f} pixels apart along the best cut, so edges would break; widen the corridor or register the images better.</source>
        <translation>Wzdłuż najlepszego cięcia oba ortoobrazy są przesunięte o {misfit:.1f} piksela, więc krawędzie byłyby przerwane; poszerz korytarz albo dopasuj lepiej obrazy.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/measure/messages.py" line="410"/>
        <source>The two orthoimages show nothing in common along the best cut; widen the corridor, or choose other images.</source>
        <translation>Wzdłuż najlepszego cięcia oba ortoobrazy nie pokazują niczego wspólnego; poszerz korytarz albo wybierz inne obrazy.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/measure/messages.py" line="421"/>
        <source>Near the seam there is too little ground that shows one orthoimage alone, so its tones can&apos;t be determined.</source>
        <translation>Przy linii mozaikowania jest za mało terenu z jednym tylko ortoobrazem, więc nie da się określić jego tonów.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/measure/messages.py" line="423"/>
        <source>One of the two orthoimages has no pixels along the new cut.</source>
        <translation>Jeden z dwóch ortoobrazów nie ma pikseli wzdłuż nowego cięcia.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/measure/messages.py" line="424"/>
        <source>The new cut keeps no more detail than the old seam, so its patch is left out.</source>
        <translation>Nowe cięcie nie wypada w pomiarze lepiej niż stara linia, więc jego łata została pominięta.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/measure/messages.py" line="433"/>
        <source>The layer of seams lacks fields of a scan ({fields}); give the seams as a scan of the mosaic writes them.</source>
        <translation>W warstwie linii mozaikowania brakuje pól skanowania ({fields}); podaj linie mozaikowania tak, jak je zapisuje badanie ortofotomapy.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/measure/messages.py" line="435"/>
        <source>The layer of seams holds no piece of seam; give the seams as a scan of the mosaic writes them.</source>
        <translation>Warstwa nie zawiera żadnego odcinka linii mozaikowania; podaj linie mozaikowania tak, jak je zapisuje badanie ortofotomapy.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/measure/messages.py" line="436"/>
        <source>None of the seams is to be mended; choose another WHAT.</source>
        <translation>Żadna linia mozaikowania nie wymaga naprawy; wybierz inne WHAT.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/measure/messages.py" line="85"/>
        <source>{share:.0f} % of the window matches none of the given sources and is left out; the verdict is that of the rest. Check their dates and add the orthoimage that is missing, unless the mosaic was altered there.</source>
        <translation>{share:.0f} % okna nie pasuje do żadnego z podanych ortoobrazów źródłowych i nie wzięło udziału; ocena dotyczy reszty. Sprawdź ich daty i dodaj brakujący ortoobraz, chyba że ortofotomapę tam zmieniono.</translation>
    </message>
    <message>
        <source>Clipping, peak and contrast come from the histogram of all valid pixels, of the luminosity (0.299 R + 0.587 G + 0.114 B) or of bands as the rules say. The peak is the fullest of 256 bins; contrast is the standard deviation as a share of the available range. In the histograms the peak should lie on green, and red is what counts as clipped.</source>
        <translation>Obcięcie, maksimum i kontrast pochodzą z histogramu wszystkich pikseli z danymi, zależnie od reguł dla jasności (0,299 R + 0,587 G + 0,114 B) albo dla kanałów. Maksimum to najliczniejszy z 256 przedziałów; kontrast to odchylenie standardowe jako część dostępnego zakresu. Na histogramach maksimum powinno leżeć na zielonym polu, a czerwone oznacza to, co liczy się jako obcięte.</translation>
    </message>
    <message>
        <source>Largest possible is the upper limit of noise, including grain of up to 1.35 px: a level has no more noise than its quietest ground varies, in all windows of the image that are as bright. Where grain that strong would make the verdict worse, it is uncertain.</source>
        <translation>Największy możliwy to najwięcej, ile może wynosić szum, łącznie z ziarnem do 1,35 px: na żadnym poziomie nie ma go więcej, niż zmienia się najspokojniejszy teren, we wszystkich równie jasnych oknach obrazu. Jeśli ziarno o takiej sile pogorszyłoby ocenę, jest ona niepewna.</translation>
    </message>
    <message>
        <source>The verdict compares noise with the scene&apos;s own detail. The amount of noise is rated by the mean over the noise&apos;s standard deviation, without texture: 40 or more is little noise, below 10 much (ISO 12232).</source>
        <translation>Ocena porównuje szum z detalami samej sceny. Poziom szumu mówi, ile szumu jest: średnia podzielona przez odchylenie standardowe szumu, po odjęciu tekstury, wynosi co najmniej 40, gdy jest mały, a poniżej 10, gdy jest duży (ISO 12232).</translation>
    </message>
    <message>
        <source>ISO 2859-2, isolated lot, LQ 5 %</source>
        <translation>ISO 2859-2, partia izolowana, LQ 5 %</translation>
    </message>
    <message>
        <source>ISO 2859-2:1985, single sampling of an isolated lot, procedure A</source>
        <translation>ISO 2859-2:1985, plan jednostopniowy dla partii izolowanej, procedura A</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/dock.py" line="114"/>
        <source>The windows are of this mosaic</source>
        <translation>Okna należą do tej ortofotomapy</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/dock.py" line="115"/>
        <source>Leave these windows as they are</source>
        <translation>Zostaw te okna bez zmian</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/messages.py" line="29"/>
        <source>{mosaic} has changed since the windows in {name} were measured and judged.</source>
        <translation>{mosaic} zmieniono po zmierzeniu i ocenieniu okien w {name}.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/measure/messages.py" line="37"/>
        <source>Places along the seams without a window, which would stick out of the mosaic or hold too few valid pixels: {count}, on seam {places}.</source>
        <translation>Miejsca wzdłuż linii mozaikowania bez okna, bo wystawałoby ono poza ortofotomapę lub miało zbyt mało ważnych pikseli: {count}, na linii {places}.</translation>
    </message>
    <message>
        <location filename="../plugin/toolkit/messages.py" line="53"/>
        <source>Window {window}: {what}</source>
        <translation>Okno {window}: {what}</translation>
    </message>
    <message>
        <location filename="../plugin/toolkit/messages.py" line="54"/>
        <source>In {count} windows ({windows}), such as {window}: {what}</source>
        <translation>Okna ({count}: {windows}), na przykład {window}: {what}</translation>
    </message>
    <message>
        <source>The words are explained after the flagged windows, under How to read this.</source>
        <translation>Znaczenie słów podano za oznaczonymi oknami, w części Jak to czytać.</translation>
    </message>
    <message>
        <source>The cross shows where the mark was found or, if it failed, where it should be by the others: column, row.</source>
        <translation>Krzyż stoi tam, gdzie znaleziono znaczek, a dla znaczka odrzuconego tam, gdzie umieszczają go pozostałe: kolumna, wiersz.</translation>
    </message>
    <message>
        <location filename="../plugin/imagery/messages.py" line="14"/>
        <source>{name} is damaged in columns {left} to {right}, rows {top} to {bottom} (GDAL: {why}); copy it again.</source>
        <translation>{name} jest uszkodzony w kolumnach od {left} do {right} i wierszach od {top} do {bottom} (GDAL: {why}); skopiuj go ponownie.</translation>
    </message>
    <message>
        <location filename="../plugin/resolution/distance_words.py" line="42"/>
        <source>{direction}, one group more or less: {low} to {high} cm</source>
        <translation>{direction}, o grupę więcej lub mniej: {low} do {high} cm</translation>
    </message>
    <message>
        <location filename="../plugin/resolution/measure/messages.py" line="64"/>
        <source>The groups show too little of the target&apos;s contrast, so the full amplitude is taken from the ground beside the bars; draw lines across coarser groups too, or make sure that this ground is as dark as the gaps.</source>
        <translation>Grupy zbyt mało mówią o kontraście testu, więc pełną amplitudę przyjęto z terenu obok pasków; narysuj linie także przez grubsze grupy albo upewnij się, że ten teren jest tak ciemny jak przerwy.</translation>
    </message>
    <message>
        <location filename="../plugin/resolution/measure/messages.py" line="71"/>
        <source>&apos;{word}&apos; is not a reference height; give metres, or a name and metres for each group, as &apos;DMC 2714; RC20 2015&apos;.</source>
        <translation>„{word}” nie jest wysokością odniesienia; podaj metry albo nazwę i metry dla każdej grupy, np. &apos;DMC 2714; RC20 2015&apos;.</translation>
    </message>
    <message>
        <location filename="../plugin/resolution/measure/messages.py" line="73"/>
        <source>There is a reference height for {name}, but no group of passes has that name; give one of: {known}.</source>
        <translation>Podano wysokość odniesienia dla {name}, ale żadna grupa przelotów tak się nie nazywa; podaj jedną z: {known}.</translation>
    </message>
    <message>
        <location filename="../plugin/resolution/measureresolution.py" line="35"/>
        <source>Finest distance that may be resolved along the flight (cm)</source>
        <translation>Najmniejsza terenowa zdolność rozdzielcza możliwa wzdłuż kierunku lotu (cm)</translation>
    </message>
    <message>
        <location filename="../plugin/resolution/measureresolution.py" line="36"/>
        <source>Coarsest distance that may be the finest one along the flight (cm)</source>
        <translation>Największa terenowa zdolność rozdzielcza możliwa wzdłuż kierunku lotu (cm)</translation>
    </message>
    <message>
        <location filename="../plugin/resolution/measureresolution.py" line="37"/>
        <source>Finest distance that may be resolved across the flight (cm)</source>
        <translation>Najmniejsza terenowa zdolność rozdzielcza możliwa w poprzek kierunku lotu (cm)</translation>
    </message>
    <message>
        <location filename="../plugin/resolution/measureresolution.py" line="38"/>
        <source>Coarsest distance that may be the finest one across the flight (cm)</source>
        <translation>Największa terenowa zdolność rozdzielcza możliwa w poprzek kierunku lotu (cm)</translation>
    </message>
    <message>
        <location filename="../plugin/resolution/minimumheight.py" line="110"/>
        <source>The minimum height that the results are compared with, or one for each sensor, type of image or direction: &apos;DMC 2714; RC20 2015&apos;.</source>
        <translation>Wysokość minimalna, z którą porównuje się wyniki, albo po jednej dla każdego sensora, typu obrazu lub kierunku: &apos;DMC 2714; RC20 2015&apos;.</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/measure/messages.py" line="40"/>
        <source>{count} points ({names}) are {low:.0f} to {high:.0f} m high, and the image&apos;s RPC holds for {first:.0f} to {last:.0f} m; apart from a shift they miss the RPC by {missed:.3g} px. Errors and recommendation mean nothing if the heights are wrong, so check them and their unit.</source>
        <translation>Punkty ({count}: {names}) mają wysokości od {low:.0f} do {high:.0f} m, a RPC obrazu obowiązuje od {first:.0f} do {last:.0f} m; poza przesunięciem różnią się od RPC o {missed:.3g} px. Błędy i zalecenie nic nie znaczą, jeśli wysokości są złe, więc sprawdź je i ich jednostkę.</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/measure/messages.py" line="44"/>
        <source>{count} points lie outside the image ({names}), where its RPC places them, too; they are used.</source>
        <translation>Liczba punktów leżących poza obrazem ({names}) tam, gdzie widzi je także jego RPC: {count}; są używane.</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/measure/messages.py" line="127"/>
        <source>{name} is read by the Python package PyYAML, which is not installed; install it, or give a camera as JSON or XML.</source>
        <translation>{name} odczytuje pakiet PyYAML języka Python, którego brak; zainstaluj go albo podaj kamerę jako JSON lub XML.</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/measure/messages.py" line="146"/>
        <source>The camera of {name} has a distortion that is not supported ({kind}); pinhole, Brown&apos;s, OpenCV&apos;s and fisheye lenses are.</source>
        <translation>Kamera z {name} ma dystorsję, która nie jest tu znana ({kind}); znane są obiektywy bez dystorsji, Browna, OpenCV i rybie oko.</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/measure/messages.py" line="153"/>
        <source>An interior orientation needs an exterior one; give it, too.</source>
        <translation>Orientacja wewnętrzna wymaga zewnętrznej; podaj także ją.</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/orthorectify.py" line="67"/>
        <source>For a table. auto: what its header says, else degrees.</source>
        <translation>W tabeli. auto: to, co mówi jej nagłówek, inaczej stopnie.</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/orthorectify.py" line="62"/>
        <source>Angles of the exterior orientation</source>
        <translation>Kąty orientacji zewnętrznej</translation>
    </message>
    <message>
        <location filename="../plugin/toolkit/messages.py" line="21"/>
        <source>The rectangle around the outline is measured where a window is not a rectangle along the mosaic&apos;s axes: {count}.</source>
        <translation>Liczba okien, które nie są prostokątami o bokach równoległych do osi ortofotomapy: {count}; mierzony jest prostokąt opisany na obrysie.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/measure/messages.py" line="316"/>
        <source>{metres:.0f} of {all:.0f} m of seam count neither as passed nor as failed; their fields &apos;state&apos; and &apos;reason&apos; say why.</source>
        <translation>{metres:.0f} z {all:.0f} m linii mozaikowania nie liczy się ani jako zaliczone, ani jako niezaliczone; powód podają ich pola &apos;state&apos; i &apos;reason&apos;.</translation>
    </message>
    <message>
        <location filename="../plugin/radiometry/checkradiometry.py" line="57"/>
        <source>Alone or beside the rasters: the sheets that &apos;Check a delivery&apos; wrote, or a tile index as gdaltindex writes it. The files that their field &apos;location&apos; names are checked.</source>
        <translation>Same lub obok rastrów: arkusze zapisane przez „Sprawdź dostawę” albo indeks arkuszy zapisany przez gdaltindex. Sprawdzane są pliki, które wskazuje ich pole „location”.</translation>
    </message>
    <message>
        <location filename="../plugin/radiometry/measure/messages.py" line="15"/>
        <source>{name} has no field &apos;{field}&apos;; give the sheets that &apos;Check a delivery&apos; wrote, or an index that gdaltindex made.</source>
        <translation>Warstwa {name} nie ma pola „{field}”; podaj arkusze zapisane przez „Sprawdź dostawę” albo indeks utworzony przez gdaltindex.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/measure/messages.py" line="343"/>
        <source>Without orthoimages this piece is not enough: between {low:.0f} and {high:.0f} % of the finest detail is kept. On this mosaic at least {needed:.0f} m of seam are needed; take longer pieces, or give the orthoimages.</source>
        <translation>Bez ortoobrazów źródłowych ten odcinek mówi za mało: zachowane jest od {low:.0f} do {high:.0f} % najdrobniejszych detali. Na tej ortofotomapie potrzeba co najmniej {needed:.0f} m linii mozaikowania; ustaw dłuższe odcinki albo podaj ortoobrazy źródłowe.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/measure/messages.py" line="355"/>
        <source>Without orthoimages a significant loss can be detected on this mosaic from about {length:.0f} m of seam on; to show that a seam is sound takes more.</source>
        <translation>Bez ortoobrazów źródłowych znacząca strata jest widoczna na tej ortofotomapie od około {length:.0f} m linii mozaikowania; stwierdzenie, że linia jest dobra, wymaga więcej.</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/checkdelivery.py" line="55"/>
        <source>Within 1 %. Empty: that of most sheets.</source>
        <translation>Z dokładnością do 1 %. Puste: tak jak w większości arkuszy.</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/checkdelivery.py" line="58"/>
        <source>Empty: that of most sheets.</source>
        <translation>Puste: tak jak w większości arkuszy.</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/checkdelivery.py" line="64"/>
        <source>8 bit is uint8, 16 bit uint16. Empty: that of most sheets.</source>
        <translation>8 bitów to uint8, 16 bitów to uint16. Puste: tak jak w większości arkuszy.</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/measure/messages.py" line="10"/>
        <source>Sheet no. {number} has no name in the field {field}; fill it in.</source>
        <translation>Arkusz nr {number} nie ma nazwy w polu {field}; wpisz ją tam.</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/measure/messages.py" line="68"/>
        <source>the longest failure without a break is {value:.1f} m and the limit is {limit:.1f} m</source>
        <translation>najdłuższa nieprzerwana usterka ma {value:.1f} m, a dopuszczalne jest {limit:.1f} m</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/measure/messages.py" line="70"/>
        <source>the longest failure without a break is {value:.1f} m and the limit is {limit:.1f} m, but it may be {low:.1f} to {high:.1f} m by the intervals of its pieces</source>
        <translation>najdłuższa usterka bez przerwy ma {value:.1f} m, a dopuszcza się {limit:.1f} m, lecz według przedziałów jej odcinków może to być od {low:.1f} do {high:.1f} m</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/measure/messages.py" line="78"/>
        <source>{value:.1%} of the metres were measured and {limit:.1%} are required</source>
        <translation>zmierzono {value:.1%} metrów, a wymagane jest {limit:.1%}</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/measure/messages.py" line="91"/>
        <source>layers of seams were changed since their scan: {count} ({names})</source>
        <translation>warstwy linii mozaikowania zmienione od czasu skanowania: {count} ({names})</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/measure/messages.py" line="219"/>
        <source>The layers are in degrees; places and lengths are given in {system}.</source>
        <translation>Warstwy są w stopniach; miejsca i długości podano w układzie {system}.</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/planinspection.py" line="56"/>
        <source>Minimum side of a window: 100 m at 0.10 m pixels gives 1024 pixels, 102.4 m.</source>
        <translation>Najmniejsza dopuszczalna długość boku okna: 100 m przy pikselu 0,10 m daje 1024 piksele, czyli 102,4 m.</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/stated_rules.py" line="113"/>
        <source>The percentage of failing pieces up to which lots should nearly always be accepted, by ISO 2859-1.</source>
        <translation>Procent niezgodnych odcinków, do którego partie powinny być prawie zawsze przyjmowane, według ISO 2859-1.</translation>
    </message>
    <message>
        <location filename="../plugin/imagery/messages.py" line="12"/>
        <source>The mask of {name}, inside it or in the file .msk beside it, is damaged; copy both again.</source>
        <translation>Maska rastra {name}, w nim samym lub w pliku .msk obok, jest uszkodzona; skopiuj oba pliki jeszcze raz.</translation>
    </message>
    <message>
        <location filename="../plugin/noise/checknoise.py" line="69"/>
        <source>A field of the windows, such as land use, scale or film: chart and report compare its values.</source>
        <translation>Pole okien, np. użytkowanie terenu, skala albo film: wykres i raport porównują jego wartości.</translation>
    </message>
    <message>
        <location filename="../plugin/radiometry/checkradiometry.py" line="61"/>
        <source>Rectangles in any reference system; each is checked separately on all rasters under it. Without windows each raster is checked as a whole.</source>
        <translation>Prostokąty w dowolnym układzie współrzędnych; każdy jest sprawdzany z osobna na wszystkich rastrach, które obejmuje. Bez okien każdy raster jest sprawdzany w całości.</translation>
    </message>
    <message>
        <location filename="../plugin/radiometry/measure/messages.py" line="13"/>
        <source>The range of values has to be two numbers, the smaller one first, such as 0,4095.</source>
        <translation>Zakres wartości muszą tworzyć dwie liczby, najpierw mniejsza, np. 0,4095.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/algorithms/mendseams.py" line="73"/>
        <source>Each seam before and after, in figures and in pictures at 2x.</source>
        <translation>Każda linia mozaikowania przed i po, w liczbach i na obrazach w powiększeniu 2x.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/algorithms/report.py" line="43"/>
        <source>The windows that &apos;Inspect windows&apos; wrote, judged by an observer or not.</source>
        <translation>Okna takie, jakie zostawia „Skontroluj okna”, ocenione przez obserwatora lub nie.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/algorithms/report.py" line="49"/>
        <source>The table of pairs of the same windows: it gives absolute contrast, and which sources are shown.</source>
        <translation>Tabela par tych samych okien: mówi o kontraście bezwzględnym i o tym, które źródła pokazać.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/judge_bar.py" line="255"/>
        <source>The key S hides the seamlines and a scan&apos;s layers, and shows them again.</source>
        <translation>Klawisz S ukrywa na mapie linie mozaikowania oraz warstwy skanowania i pokazuje je znowu.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/judging_desk.py" line="47"/>
        <source>Judge</source>
        <translation>Oceń</translation>
    </message>
    <message>
        <location filename="../plugin/seams/measure/messages.py" line="398"/>
        <source>{name} and {count} more show the same pixels where they overlap: they are parts of one image and are treated as one.</source>
        <translation>{name} i {count} innych pokazują te same piksele tam, gdzie się nakładają: są częściami jednego obrazu i tak są traktowane.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/measure/messages.py" line="158"/>
        <source>{measure} separates every visible loss from the other windows, so resampling shows no error; the interval is the score interval.</source>
        <translation>{measure} odróżnia każde okno z widoczną stratą od każdego innego, więc losowanie nie pokazuje błędu; podano przedział wynikowy (score).</translation>
    </message>
    <message>
        <location filename="../plugin/seams/measure/messages.py" line="162"/>
        <source>{measure}: all verdicts of one kind lie in one neighbourhood, so each window counts as independent and the intervals are too narrow; judge windows elsewhere too.</source>
        <translation>{measure}: oceny jednego rodzaju leżą w jednym sąsiedztwie, więc każde okno liczy się jako niezależne i przedziały są za wąskie; oceń też okna w innych miejscach.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/measure/messages.py" line="244"/>
        <source>The seamline layer names no orthoimages; the sides of its seams are named by the dates in the field &apos;{field}&apos;.</source>
        <translation>Warstwa linii mozaikowania nie nazywa ortoobrazów; strony linii nazwano datami z pola &apos;{field}&apos;.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/report/mending_report.py" line="27"/>
        <source>mended</source>
        <translation>naprawione</translation>
    </message>
    <message>
        <location filename="../plugin/seams/report/mending_report.py" line="27"/>
        <source>improved</source>
        <translation>poprawione</translation>
    </message>
    <message>
        <location filename="../plugin/seams/report/mending_report.py" line="27"/>
        <source>left</source>
        <translation>pozostawione</translation>
    </message>
    <message>
        <location filename="../plugin/seams/report/mending_report.py" line="59"/>
        <source>{seam}, from {station} m</source>
        <translation>{seam}, od {station} m</translation>
    </message>
    <message>
        <location filename="../plugin/seams/report/mending_report.py" line="66"/>
        <source>where the seam was</source>
        <translation>gdzie była linia</translation>
    </message>
    <message>
        <location filename="../plugin/seams/report/mending_report.py" line="66"/>
        <source>where it is now</source>
        <translation>gdzie jest teraz</translation>
    </message>
    <message>
        <location filename="../plugin/seams/report/mending_report.py" line="33"/>
        <source>corridor on either side (m)</source>
        <translation>korytarz po każdej stronie (m)</translation>
    </message>
    <message>
        <location filename="../plugin/seams/report/mending_report.py" line="34"/>
        <source>blend (px)</source>
        <translation>mieszanie (px)</translation>
    </message>
    <message>
        <location filename="../plugin/seams/report/mending_report.py" line="75"/>
        <source>before</source>
        <translation>przed</translation>
    </message>
    <message>
        <location filename="../plugin/seams/report/mending_report.py" line="75"/>
        <source>after</source>
        <translation>po</translation>
    </message>
    <message>
        <location filename="../plugin/seams/report/mending_report.py" line="40"/>
        <source>metres {outcome}</source>
        <translation>metry: {outcome}</translation>
    </message>
    <message>
        <location filename="../plugin/seams/words.py" line="185"/>
        <source>The channels were corrected one by one, so the colours shifted.</source>
        <translation>Kanały korygowano osobno, przez co zmieniły się barwy.</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/fitsensormodel.py" line="45"/>
        <source>quotients of order 2 at most, without the terms that the points do not support</source>
        <translation>ilorazowy model wielomianowy najwyżej II stopnia, bez wyrazów, których punkty nie potwierdzają</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/measure/messages.py" line="71"/>
        <source>Blunders found and left out of fit and errors: {count} ({names}); check those points and measure them again.</source>
        <translation>Błędy grube znalezione i pominięte w błędach: {count} ({names}); sprawdź te punkty i zmierz je ponownie.</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/measure/messages.py" line="77"/>
        <source>{count} points miss the model by far more than the others ({names}); check them, or look for blunders (ROBUST).</source>
        <translation>{count} punktów odbiega od modelu znacznie bardziej niż pozostałe ({names}); sprawdź je albo włącz wyszukiwanie błędów grubych (ROBUST).</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/measure/messages.py" line="129"/>
        <source>According to {name} a pixel is {ratio:.2g} times as wide as it is high; check whether the sensor&apos;s sides are interchanged.</source>
        <translation>Według {name} szerokość piksela to {ratio:.2g} jego wysokości; sprawdź, czy boki matrycy nie są zamienione.</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/measure/messages.py" line="134"/>
        <source>The rotation of {name} is read as {way} usually writes it, since no file states it; check the orthoimage&apos;s position.</source>
        <translation>Obrót {name} przyjęto tak, jak zwykle zapisuje go {way}, czego żaden plik nie mówi; sprawdź położenie ortoobrazu.</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/measure/messages.py" line="137"/>
        <source>{name} is read in the plane tangent to the Earth at its reference, as OpenSfM writes it. One that OpenDroneMap has put into UTM is read correctly only inside its project&apos;s folder.</source>
        <translation>{name} jest odczytany w płaszczyźnie stycznej do Ziemi w jego punkcie odniesienia, jak zapisuje go OpenSfM. Plik przeliczony przez OpenDroneMap do UTM jest czytany poprawnie tylko w katalogu swojego projektu.</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/measure/messages.py" line="139"/>
        <source>Photos are placed by {exact}, the exact reconstruction beside {name}.</source>
        <translation>Zdjęcia są umieszczone według {exact}, dokładnej rekonstrukcji obok {name}.</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/measure/messages.py" line="141"/>
        <source>{name} is read in {system} with the offset of {offsets}, where OpenDroneMap puts it approximately: up to some decimetres off in a block of a kilometre.</source>
        <translation>{name} jest odczytany w układzie {system} z przesunięciem z {offsets}, dokąd OpenDroneMap przelicza go w przybliżeniu: błąd do kilku decymetrów w bloku kilometrowym.</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/measure/messages.py" line="158"/>
        <source>{name} is oriented and is not in {folder}; it is left out.</source>
        <translation>{name} ma orientację, a nie ma go w {folder}; zostaje pominięte.</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/measure/messages.py" line="160"/>
        <source>None of the photos that {name} names is in {folder}; choose their folder (PHOTOS).</source>
        <translation>W {folder} nie ma żadnego ze zdjęć, które wymienia {name}; wskaż ich katalog (PHOTOS).</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/measure/messages.py" line="161"/>
        <source>The terrain is that of the project: {name}.</source>
        <translation>Teren pochodzi z projektu: {name}.</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/orthorectify.py" line="48"/>
        <source>All files (*)</source>
        <translation>Wszystkie pliki (*)</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/orthorectify.py" line="216"/>
        <source>Orthorectify a block of photos</source>
        <translation>Ortorektyfikacja bloku zdjęć</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/orthorectify.py" line="231"/>
        <source>Terrain heights under all photos, in any reference system. Empty: the terrain or surface model of an OpenDroneMap project.</source>
        <translation>Wysokości terenu pod wszystkimi zdjęciami, w dowolnym układzie współrzędnych. Puste: model terenu albo pokrycia z projektu OpenDroneMap.</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/orthorectify.py" line="234"/>
        <source>System of the orthoimages. Empty: the UTM zone of the first photo.</source>
        <translation>Ortoobrazów. Puste: strefa UTM pierwszego zdjęcia.</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/orthorectify.py" line="237"/>
        <source>A folder: a GeoTIFF of each photo, under its name; empty where the photo or the terrain model ends.</source>
        <translation>Katalog: GeoTIFF każdego zdjęcia pod jego nazwą; pusty tam, gdzie kończy się zdjęcie albo NMT.</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/orthorectify.py" line="236"/>
        <source>Orthoimages</source>
        <translation>Ortoobrazy</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/orthorectify.py" line="239"/>
        <source>Orthoimages made</source>
        <translation>Wykonane ortoobrazy</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/orthorectify.py" line="239"/>
        <source>Photos without an orthoimage</source>
        <translation>Zdjęcia bez ortoobrazu</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/fitsensormodel.py" line="246"/>
        <source>The sensor model to be fitted, with its order or form. rpc_bias needs an RPC.</source>
        <translation>Model sensora, który będzie dopasowany, wraz ze stopniem lub postacią. rpc_bias wymaga RPC.</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/fitsensormodel.py" line="258"/>
        <source>For each ground coordinate of a point, as it will be surveyed.</source>
        <translation>Każdej z trzech współrzędnych terenowych punktu, z jakim będą pomierzone.</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/fitsensormodel.py" line="263"/>
        <source>Height above the ellipsoid. Points lie anywhere between the lowest and the highest.</source>
        <translation>Wysokość nad elipsoidą. Każdy punkt leży gdziekolwiek między najniższą a najwyższą.</translation>
    </message>
    <message>
        <location filename="../plugin/toolkit/messages.py" line="25"/>
        <source>&apos;{parameter}&apos; is &apos;{value}&apos;, which is not a number; write it with a point, such as 0.7.</source>
        <translation>&apos;{parameter}&apos; ma wartość &apos;{value}&apos;, która nie jest liczbą; zapisz ją z kropką, jak 0.7.</translation>
    </message>
    <message>
        <source>Unclear: pieces measured too roughly to tell which side of the limit they are on; they count by their value.</source>
        <translation>Niejasne: odcinki zmierzone zbyt zgrubnie, aby na pewno powiedzieć, po której stronie granicy leżą; liczą się według swojej wartości.</translation>
    </message>
    <message>
        <source>Mended seams</source>
        <translation>Naprawione linie mozaikowania</translation>
    </message>
    <message>
        <source>All mended</source>
        <translation>Wszystkie naprawione</translation>
    </message>
    <message>
        <source>Not all mended</source>
        <translation>Nie wszystkie naprawione</translation>
    </message>
    <message>
        <source>Mended: 0.9 or more of the finest detail is kept, measured as in a scan.</source>
        <translation>Naprawione jest to, co zachowuje co najmniej 0,9 najdrobniejszych detali, zmierzone tak jak w skanowaniu.</translation>
    </message>
    <message>
        <source>kept before</source>
        <translation>zachowane przed</translation>
    </message>
    <message>
        <source>kept after</source>
        <translation>zachowane po</translation>
    </message>
    <message>
        <source>step before (DN)</source>
        <translation>skok przed (DN)</translation>
    </message>
    <message>
        <source>step after (DN)</source>
        <translation>skok po (DN)</translation>
    </message>
    <message>
        <source>misfit (px)</source>
        <translation>niedopasowanie (px)</translation>
    </message>
    <message>
        <source>outcome</source>
        <translation>wynik</translation>
    </message>
    <message>
        <source>Kept is the share of the finest detail beside the seam, relative to the ground around. Step is that of tone across the seam, less what the ground itself shows. Misfit says how far the two orthoimages lie apart along the new cut.</source>
        <translation>Zachowane to część najdrobniejszych detali przy linii względem otaczającego terenu. Skok to różnica tonu w poprzek linii, pomniejszona o to, co pokazuje sam teren. Niedopasowanie mówi, jak daleko od siebie leżą oba ortoobrazy wzdłuż nowego cięcia.</translation>
    </message>
    <message>
        <location filename="../plugin/toolkit/messages.py" line="19"/>
        <source>Windows without a number of their own: {count}; they were given the next free ones.</source>
        <translation>Okna bez własnego numeru: {count}; otrzymały kolejne wolne numery.</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/paper/acceptance_report.py" line="287"/>
        <source>{length} unclear</source>
        <translation>niejasne: {length}</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/stated_rules.py" line="38"/>
        <source>below it a loss is called significant</source>
        <translation>poniżej niej strata uchodzi za istotną</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/stated_rules.py" line="39"/>
        <source>Beeldmateriaal (NL) lets 2 % deviate if it is not contiguous</source>
        <translation>Beeldmateriaal (NL) dopuszcza 2 % odstępstw, jeśli nie są ciągłe</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/stated_rules.py" line="40"/>
        <source>half a standard window of 100 m</source>
        <translation>połowa standardowego okna 100 m</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/stated_rules.py" line="41"/>
        <source>nothing is accepted on a guess</source>
        <translation>niczego nie przyjmuje się na podstawie domysłu</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/stated_rules.py" line="89"/>
        <source>the software&apos;s default ({parameter}): {origin}</source>
        <translation>wartość domyślna programu ({parameter}): {origin}</translation>
    </message>
    <message>
        <location filename="../plugin/noise/checknoise.py" line="74"/>
        <source>One row per window, raster and band: relative variances, kurtosis of each level&apos;s details (3 for Gaussian noise), sigma in DN, the most that grain can be, the verdict low, uncertain, moderate or strong, and beside it the amount of noise by the signal to noise ratio: little, some or much; at most some where texture can hide it, uncertain where texture can hide much.</source>
        <translation>Jeden wiersz na okno, raster i kanał: wariancja względna, kurtoza detali każdego poziomu (3 dla szumu gaussowskiego), sigma w DN, największe możliwe ziarno, ocena low, uncertain, moderate lub strong, a obok niej poziom szumu według stosunku sygnału do szumu: little, some lub much; at most some, gdy umiarkowany szum może kryć się w teksturze, uncertain, gdy może się w niej kryć duży.</translation>
    </message>
    <message>
        <location filename="../plugin/noise/noise_summary.py" line="34"/>
        <source>at most some</source>
        <translation>co najwyżej umiarkowany</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/fitsensormodel.py" line="183"/>
        <source>Fits every sensor model that the points allow and judges each on points that its fit has not seen: check points, or, where they are fewer than five, every point predicted from the others. The table is that of Kurczynski and Wolniewicz. Among the models whose errors, there and at control points left out in turn, differ only by chance, the one with the fewest unknowns is recommended; plane polynomials for flat ground only.</source>
        <translation>Dopasowuje każdy model sensora, na który pozwalają punkty, i ocenia każdy na punktach, których dopasowanie nie widziało: na punktach kontrolnych, a gdy jest ich mniej niż pięć, na każdym punkcie przewidzianym z pozostałych. Tabela jest taka jak u Kurczyńskiego i Wolniewicza. Spośród modeli, których błędy, tam oraz na kolejno pomijanych fotopunktach, różnią się nie bardziej niż przypadkowo, zalecany jest model o najmniejszej liczbie niewiadomych; wielomiany płaskie tylko dla terenu płaskiego.</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/orthorectify.py" line="218"/>
        <source>Puts all aerial photos of a block on the map over a terrain model, on one grid of pixels: those that the file of their orientations names. For an OpenDroneMap project the folder, or reconstruction.json, is enough. A photo that can&apos;t be used is named, and the others are processed.</source>
        <translation>Umieszcza na mapie wszystkie zdjęcia lotnicze bloku, z użyciem NMT i na jednej siatce pikseli: te, które wymienia plik ich orientacji. W przypadku projektu OpenDroneMap wystarczy katalog albo reconstruction.json. Zdjęcie, którego nie można użyć, jest wymieniane, a pozostałe powstają.</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/orthorectify.py" line="226"/>
        <source>For a project nothing else is needed. Empty: the photos are in images of the exterior orientation&apos;s project, else in the folder of its file.</source>
        <translation>W przypadku projektu nie trzeba podawać nic więcej. Puste: zdjęcia są w katalogu images projektu, z którego pochodzi orientacja zewnętrzna, w przeciwnym razie w katalogu jej pliku.</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/orthorectify.py" line="224"/>
        <source>Folder of an OpenDroneMap project, or of photos</source>
        <translation>Katalog projektu OpenDroneMap lub katalog zdjęć</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/measure/messages.py" line="13"/>
        <source>Pieces of seam outside of all sheets: {count}. They are listed under their layer&apos;s name.</source>
        <translation>Odcinki linii leżące poza arkuszami: {count}. Zachowują nazwę swojej warstwy.</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/measure/messages.py" line="109"/>
        <source>parts of the mosaic match no orthoimage, and {metres:.0f} m of border around them may be seams that are not counted: with these only {value:.1%} of the metres were measured and {limit:.1%} are required</source>
        <translation>części ortofotomapy nie odpowiadają żadnemu ortoobrazowi, a {metres:.0f} m ich granic może być liniami, których nie ujęto w żadnej liczbie: łącznie z nimi zmierzono tylko {value:.1%} metrów, a wymaga się {limit:.1%}</translation>
    </message>
    <message>
        <location filename="../plugin/radiometry/checkradiometry.py" line="147"/>
        <source>Radiometry: {word}.</source>
        <translation>Radiometria: {word}.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/measure/messages.py" line="145"/>
        <source>{field} of {count} windows is not a possible measurement; it is left out.</source>
        <translation>{field} w oknach ({count}) jest liczbą, której nie daje żaden pomiar; została pominięta.</translation>
    </message>
    <message>
        <location filename="../plugin/toolkit/messages.py" line="34"/>
        <source>Seam Inspector was updated or turned off while this ran; start it again.</source>
        <translation>Seam Inspector został zaktualizowany albo wyłączony w trakcie pracy; uruchom to ponownie.</translation>
    </message>
    <message>
        <location filename="../plugin/photos/measure/messages.py" line="116"/>
        <source>The mark &apos;{mark}&apos; was measured at column {column:g}, row {row:g}, where no scanned photo has pixels; correct or remove it.</source>
        <translation>Znaczek &apos;{mark}&apos; zmierzono w kolumnie {column:g}, wierszu {row:g}, gdzie żadne skanowane zdjęcie nie ma pikseli; popraw go lub usuń.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/measure/messages.py" line="426"/>
        <source>What the new cut keeps can&apos;t be measured, so its patch is left out.</source>
        <translation>Nie można zmierzyć, ile zachowuje nowe cięcie, więc jego łata została pominięta.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/measure/messages.py" line="427"/>
        <source>The seam does not lie on this mosaic; give the seams that a scan of it found.</source>
        <translation>Linia nie leży na tej ortofotomapie; podaj linie znalezione przy jej skanowaniu.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/measure/messages.py" line="69"/>
        <source>No source explains the mosaic&apos;s fine detail here; add the orthoimages that it was made from.</source>
        <translation>Żaden ortoobraz źródłowy nie wyjaśnia tu drobnych detali ortofotomapy; dodaj ortoobrazy, z których powstała.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/measure/messages.py" line="75"/>
        <source>Two images are mixed on {share:.0f} % of the window: there is no seam, and no unmixed ground to compare with.</source>
        <translation>Dwa obrazy są zmieszane na {share:.0f} % okna: nie ma linii ani niezmieszanego terenu do porównania.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/measure/messages.py" line="79"/>
        <source>There is too little ground beside the seam to compare it with; take a larger window, or move it.</source>
        <translation>Obok linii mozaikowania jest za mało terenu do porównania; weź większe okno albo je przesuń.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/measure/messages.py" line="82"/>
        <source>{share:.0f} % of the window matches none of the given sources: check their dates, and add the missing one.</source>
        <translation>{share:.0f} % okna nie pasuje do żadnego z podanych ortoobrazów źródłowych: sprawdź ich daty i dodaj brakujący.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/measure/messages.py" line="89"/>
        <source>Along the seam the mosaic has {low:.0f} to {high:.0f} % of its sources&apos; detail: add those that it was made from.</source>
        <translation>Wzdłuż linii mozaikowania ortofotomapa ma od {low:.0f} do {high:.0f} % detali ortoobrazów źródłowych: dodaj te, z których powstała.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/words.py" line="274"/>
        <source>cause unclear</source>
        <translation>przyczyna niejasna</translation>
    </message>
    <message>
        <location filename="../plugin/seams/words.py" line="146"/>
        <source>mixed by another rule</source>
        <translation>zmieszano inaczej niż wagami</translation>
    </message>
    <message>
        <location filename="../plugin/seams/words.py" line="139"/>
        <source>feathered</source>
        <translation>wtapianie</translation>
    </message>
    <message>
        <location filename="../plugin/seams/window_summary.py" line="274"/>
        <source>It may be more: judge by eye.</source>
        <translation>Może być większa: oceń wzrokiem.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/window_summary.py" line="278"/>
        <source>Judge by eye.</source>
        <translation>Oceń wzrokiem.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/words.py" line="132"/>
        <source>blurred</source>
        <translation>rozmycie</translation>
    </message>
    <message>
        <location filename="../plugin/seams/words.py" line="133"/>
        <source>Leave out that filter.</source>
        <translation>Pomiń ten filtr.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/words.py" line="147"/>
        <source>Cut hard there.</source>
        <translation>Tnij tam ostro.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/words.py" line="180"/>
        <source>clipped</source>
        <translation>obcięcie</translation>
    </message>
    <message>
        <location filename="../plugin/seams/words.py" line="181"/>
        <source>Stretch it less.</source>
        <translation>Rozciągaj ją słabiej.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/words.py" line="197"/>
        <source>Register images.</source>
        <translation>Dopasuj obrazy.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/words.py" line="208"/>
        <source>Add the missing orthoimage.</source>
        <translation>Dodaj brakujący ortoobraz.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/words.py" line="219"/>
        <source>Don&apos;t resample it.</source>
        <translation>Zachowaj piksele ortoobrazów.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/words.py" line="237"/>
        <source>compressed with loss</source>
        <translation>kompresja stratna</translation>
    </message>
    <message>
        <location filename="../plugin/radiometry/measure/messages.py" line="55"/>
        <source>Histograms of {drawn} of the {count} images are drawn, those of images that are not accepted first.</source>
        <translation>Narysowano histogramy {drawn} z {count} obrazów, najpierw tych, które nie zostały przyjęte.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/measure/messages.py" line="413"/>
        <source>The orthoimages differ from the mosaic on {share:.1%} of the ground near the seam, as those of another date do, or any where its tones are clipped at white or black; choose those that it was made from.</source>
        <translation>Ortoobrazy przedstawiają {share:.1%} terenu przy linii mozaikowania inaczej niż ortofotomapa, jak ortoobrazy z innego terminu albo inne tam, gdzie jej tony są obcięte w bieli lub czerni; wybierz te, z których ją wykonano.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/measure/messages.py" line="417"/>
        <source>{name} has {share:.0%} of the mosaic&apos;s fine detail beside the seam (band {band}), so it can&apos;t replace the mosaic there; choose the images that the mosaic was made from.</source>
        <translation>{name} przedstawia {share:.0%} drobnych detali, które ortofotomapa ma przy linii mozaikowania (kanał {band}), więc nie może ich zastąpić; wybierz ortoobrazy, z których ją wykonano.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/window_summary.py" line="266"/>
        <source>{said}, no more along the seam</source>
        <translation>{said}, wzdłuż linii nie więcej</translation>
    </message>
    <message>
        <location filename="../plugin/seams/window_summary.py" line="241"/>
        <source>In all {area}.</source>
        <translation>Łącznie {area}.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/window_summary.py" line="257"/>
        <source>{lost} % of the window&apos;s detail lost</source>
        <translation>{lost} % detali okna utracono</translation>
    </message>
    <message>
        <location filename="../plugin/seams/window_summary.py" line="263"/>
        <source>{said}, {lost} % of the rest along the seam</source>
        <translation>{said}, wzdłuż linii {lost} % reszty</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/measure/messages.py" line="224"/>
        <source>Use {model}: {rmse:.2f} m on points not used in its fit (the best has {best:.2f} m). {why}</source>
        <translation>Użyj modelu {model}: {rmse:.2f} m na punktach, których nie widział (najlepszy ma {best:.2f} m). {why}</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/measure/messages.py" line="225"/>
        <source>A parametric model needs few points and does not oscillate between them.</source>
        <translation>Model parametryczny potrzebuje niewielu punktów i nie faluje między nimi.</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/measure/messages.py" line="226"/>
        <source>The vendor&apos;s RPC holds the image&apos;s geometry and a few points remove its offset.</source>
        <translation>RPC dostawcy zawiera geometrię obrazu, a kilka punktów usuwa jego przesunięcie.</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/measure/messages.py" line="228"/>
        <source>Without a parametric basis, quotients are the soundest models, but they need many, well spread points.</source>
        <translation>Z modeli nieparametrycznych najbardziej wiarygodne są ilorazowe, ale potrzebują wielu dobrze rozłożonych punktów.</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/measure/messages.py" line="229"/>
        <source>It is the quotient of lowest order with one denominator and needs the fewest points.</source>
        <translation>To model ilorazowy najniższego stopnia z jednym mianownikiem; potrzebuje najmniej punktów.</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/measure/messages.py" line="231"/>
        <source>Polynomials suit small areas only and oscillate between the points, so watch the check points.</source>
        <translation>Wielomiany nadają się tylko do małych obszarów i falują między punktami, więc obserwuj punkty kontrolne.</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/measure/messages.py" line="233"/>
        <source>The terrain is flat enough for a plane model, which serves for small areas only.</source>
        <translation>Teren jest dość płaski dla modelu płaskiego, który nadaje się tylko do małych obszarów.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/words.py" line="252"/>
        <source>dodging took {value} %</source>
        <translation>wyrównanie jasności zabrało {value} %</translation>
    </message>
    <message>
        <location filename="../plugin/seams/words.py" line="253"/>
        <source>dodged</source>
        <translation>wyrównana jasność</translation>
    </message>
    <message>
        <location filename="../plugin/seams/words.py" line="254"/>
        <source>Dodge it less.</source>
        <translation>Wyrównaj jasność słabiej.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/words.py" line="250"/>
        <source>Brightness was evened out from place to place; from a coarse overview, this removes detail.</source>
        <translation>Jasność wyrównano zmiennie z miejsca na miejsce; zrobione według zgrubnego podglądu zabiera to szczegóły.</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/checkdelivery.py" line="73"/>
        <source>A virtual mosaic over the ordered sheets that fit together; nothing is copied.</source>
        <translation>Wirtualna ortofotomapa zamówionych arkuszy, które do siebie pasują; nic nie jest kopiowane.</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/measure/messages.py" line="73"/>
        <source>the longest failure without a break is {value:.1f} m and the limit is {limit:.1f} m, but a row of pieces that were not measured may make it {metres:.1f} m</source>
        <translation>najdłuższa nieprzerwana usterka ma {value:.1f} m, a dopuszczalne jest {limit:.1f} m, lecz przez ciąg odcinków, których nie zmierzono, może to być {metres:.1f} m</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/measure/messages.py" line="86"/>
        <source>sheets of which nothing was measured: {count} ({names})</source>
        <translation>arkusze, z których niczego nie zmierzono: {count} ({names})</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/measure/messages.py" line="87"/>
        <source>sheets that are missing in the mosaic that was scanned: {count} ({names})</source>
        <translation>arkusze, których brakuje w zeskanowanej ortofotomapie: {count} ({names})</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/measure/messages.py" line="88"/>
        <source>sheets whose pixels can&apos;t all be read: {count} ({names})</source>
        <translation>arkusze, których pikseli nie da się w całości odczytać: {count} ({names})</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/measure/messages.py" line="93"/>
        <source>layers of seams without the seal of a scan: {count} ({names})</source>
        <translation>warstwy linii mozaikowania bez pieczęci skanowania: {count} ({names})</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/measure/messages.py" line="95"/>
        <source>files were changed since they were scanned: {count} ({names})</source>
        <translation>pliki zmienione od czasu skanowania: {count} ({names})</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/measure/messages.py" line="97"/>
        <source>files of the scanned mosaic can no longer be found: {count} ({names})</source>
        <translation>nie znaleziono plików skanowanej ortofotomapy: {count} ({names})</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/measure/messages.py" line="118"/>
        <source>along {metres:.0f} m around {place} the mosaic passes from one orthoimage to another and no seam is measured, and {limit:.1f} m may fail without a break</source>
        <translation>na {metres:.0f} m przy {place} ortofotomapa przechodzi z jednego ortoobrazu w drugi, a linii mozaikowania nie zmierzono; bez przerwy może zawieść {limit:.1f} m</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/measure/messages.py" line="168"/>
        <source>What would decide it: the layers of seams as their scans wrote them, in the GeoPackages themselves or copies of these files; exports, merged layers and other formats lose the seal. Scan again where they are lost.</source>
        <translation>Co by rozstrzygnęło: warstwy linii mozaikowania takie, jak zapisało je skanowanie, w tych samych plikach GeoPackage albo w ich kopiach; eksport, łączenie warstw i inne formaty gubią pieczęć. Gdzie ich już nie ma, skanuj ponownie.</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/measure/messages.py" line="192"/>
        <source>Orthoimages that were scanned can no longer be found: {count} ({names}); without them the measurements behind the decision can&apos;t be repeated.</source>
        <translation>Nie znaleziono ortoobrazów, które skanowano: {count} ({names}); bez nich nikt nie zmierzy ponownie tego, na czym opiera się decyzja.</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/measure/messages.py" line="236"/>
        <source>The mosaic was compared with the orthoimages that were given. Detail that these lack too does not count as lost: make sure that the mosaic was made from them.</source>
        <translation>Ortofotomapę porównano z podanymi ortoobrazami. Szczegóły, których brak także w nich, nie liczą się jako utracone: upewnij się, że to z nich ją wykonano.</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/measure/messages.py" line="263"/>
        <source>it is not part of the mosaic of all sheets</source>
        <translation>nie wchodzi w skład ortofotomapy wszystkich arkuszy</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/paper/acceptance_report.py" line="191"/>
        <source>seams given and found</source>
        <translation>linie mozaikowania podane i znalezione</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/paper/acceptance_report.py" line="191"/>
        <source>ground that matches no orthoimage</source>
        <translation>teren nieodpowiadający żadnemu ortoobrazowi</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/paper/acceptance_report.py" line="191"/>
        <source>no data within the mosaic&apos;s outline</source>
        <translation>brak danych w obrębie obrysu ortofotomapy</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/paper/acceptance_report.py" line="207"/>
        <source>{share} of the ground with texture</source>
        <translation>{share} tego, co ma teksturę</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/paper/acceptance_report.py" line="195"/>
        <source>not stated in the layers of seams</source>
        <translation>warstwy linii tego nie podają</translation>
    </message>
    <message>
        <location filename="../plugin/seams/algorithms/inspectwindows.py" line="40"/>
        <source>Measures how much local contrast a mosaic kept in each window. The mosaic and every source that meets the window are clipped and decomposed by wavelets, and the share of the sources&apos; finest detail that the mosaic has beside a seam is compared with the share farther off: whatever was done to the whole mosaic cancels out. A loss is significant where by the best estimate 70 % or less is kept along the seam and some loss is certain, reduced where the 95 % interval lies below 100 %. The paper&apos;s own rule (Pyka 2010), by shares of variance in whole clips, is applied too: half of the detail or less against every source is a significant loss.</source>
        <translation>Mierzy, ile lokalnego kontrastu ortofotomapa zachowała w każdym oknie. Ortofotomapa i każdy ortoobraz źródłowy, który sięga okna, są wycinane i rozkładane falkami, a to, co ortofotomapa ma z najdrobniejszych detali ortoobrazów przy linii mozaikowania, jest porównywane z tym, co ma z nich dalej: wszystko, co zrobiono z całą ortofotomapą, przestaje się liczyć. Strata jest istotna (significant), gdy według najlepszego oszacowania wzdłuż linii mozaikowania zachowano 70 % lub mniej, a to, że coś stracono, jest pewne; kontrast jest osłabiony (reduced), gdy na pewno zachowano mniej niż wszystko. Jest też reguła z artykułu (Pyka 2010), według udziałów wariancji w całych wycinkach: połowa detali lub mniej względem każdego ortoobrazu to strata istotna.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/algorithms/inspectwindows.py" line="71"/>
        <source>A window is significant when by the best estimate this share of the finest detail, or less, is kept along its seam, and some loss is certain. 0.5 is what a 50:50 blend leaves of two images that have nothing in common.</source>
        <translation>Okno otrzymuje ocenę „istotna strata” (significant), gdy według najlepszego oszacowania wzdłuż jego linii mozaikowania zachowana jest taka część najdrobniejszych detali lub mniejsza, a to, że coś stracono, jest pewne. 0,5 zostaje po zmieszaniu 50:50 dwóch obrazów, które nie mają nic wspólnego.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/inputs/inputs_panel.py" line="283"/>
        <source>By the seam, a loss is significant when by the best estimate at most this share of the finest detail is kept along it, and some loss is certain</source>
        <translation>Według linii mozaikowania strata jest istotna, gdy według najlepszego oszacowania wzdłuż niej zachowana jest najwyżej taka część najdrobniejszych detali, a to, że coś stracono, jest pewne</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/session.py" line="69"/>
        <source>Show where detail was lost, over the map and the images (L while judging). One scale for all windows</source>
        <translation>Pokaż, gdzie utracono detale, na mapie i na obrazach (L podczas oceny). Jedna skala dla wszystkich okien</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/map/lost_detail.py" line="297"/>
        <source>Detail kept</source>
        <translation>Zachowane detale</translation>
    </message>
    <message>
        <location filename="../plugin/seams/measure/messages.py" line="372"/>
        <source>{name} matches the mosaic on both sides of its seams, so it is a copy or an overview of it, or the mosaic that this one was cut from. It would hide every loss and is left out of the sources.</source>
        <translation>{name} zmienia się wraz z ortofotomapą na jej liniach łączenia, jest więc jej kopią lub podglądem albo ortofotomapą, z której ją wycięto. Ukryłby każdą stratę, dlatego pominięto go wśród źródeł.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/measure/messages.py" line="381"/>
        <source>{name} is the same as the mosaic wherever they were compared. It is used, as it may be one of the orthoimages; if it is a copy of the mosaic or a part of it, it hides every loss there, so remove it from the sources.</source>
        <translation>{name} jest identyczny z ortofotomapą wszędzie, gdzie je porównano. Bierze udział, bo może być jednym z ortoobrazów; jeśli jest kopią ortofotomapy lub jej części, ukrywa tam każdą stratę, więc usuń go ze źródeł.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/measure/messages.py" line="385"/>
        <source>{name} is like the mosaic wherever they were compared, as orthoimages of one ground can be. If it was made from the mosaic, it hides losses, so remove it from the sources.</source>
        <translation>{name} jest podobny do ortofotomapy wszędzie, gdzie je porównano, jak bywa z ortoobrazami tego samego terenu. Jeśli powstał z ortofotomapy, ukrywa straty, więc usuń go ze źródeł.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/measure/messages.py" line="188"/>
        <source>The format of SEAMS can&apos;t hold the seal of the scan, without which no delivery is accepted; write SEAMS as GeoPackage.</source>
        <translation>Format warstwy linii mozaikowania SEAMS nie ma miejsca na pieczęć skanowania, bez której żadna dostawa nie zostanie przyjęta; zapisz SEAMS jako GeoPackage.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/measure/messages.py" line="211"/>
        <source>Nothing of the mosaic {name} could be read, so nothing was measured: {why}</source>
        <translation>Z ortofotomapy {name} nie udało się niczego odczytać, więc niczego nie zmierzono: {why}</translation>
    </message>
    <message>
        <location filename="../plugin/seams/measure/messages.py" line="213"/>
        <source>No orthoimage could be read, so nothing was measured; fix that, or leave them all out to scan the mosaic along its seamlines alone: {why}</source>
        <translation>Nie udało się odczytać żadnego ortoobrazu, więc niczego nie zmierzono; usuń tę przeszkodę albo nie podawaj żadnego, aby zeskanować samą ortofotomapę wzdłuż linii mozaikowania: {why}</translation>
    </message>
    <message>
        <location filename="../plugin/seams/measure/messages.py" line="335"/>
        <source>{share:.2g} % of the mosaic could not be read, for example around {x:.1f}, {y:.1f}, and count as not measured. Copy its files again and scan again.</source>
        <translation>Nie udało się odczytać {share:.2g} % ortofotomapy, na przykład wokół {x:.1f}; {y:.1f}; liczy się to jako niezmierzone. Skopiuj jej pliki na nowo i powtórz skan.</translation>
    </message>
    <message>
        <source>Significant: by the best estimate {percent} % or less of the finest detail is kept along the seam, and some loss is certain; or the whole window is badly blurred. Reduced: some detail is lost, beyond the error of the measurement. Preserved: no certain loss.</source>
        <translation>Istotna strata: według najlepszego oszacowania wzdłuż linii mozaikowania zachowano {percent} % najdrobniejszych detali lub mniej, a to, że coś stracono, jest pewne; albo całe okno jest mocno rozmyte. Osłabione: na pewno zachowano mniej niż wszystko. Zachowane: żadna strata nie jest pewna.</translation>
    </message>
    <message>
        <location filename="../plugin/toolkit/messages.py" line="12"/>
        <source>{name} can&apos;t be saved in the mosaic&apos;s reference system, as a GeoPackage can&apos;t store it; give the mosaic another one, such as one with an EPSG code.</source>
        <translation>Plik {name} nie leżałby w układzie współrzędnych ortofotomapy, bo układu tego nie da się zapisać w GeoPackage; nadaj ortofotomapie inny układ, na przykład z kodem EPSG.</translation>
    </message>
    <message>
        <source>Rows that were not measured</source>
        <translation>Ciągi, których nie zmierzono</translation>
    </message>
    <message>
        <source>Consecutive pieces that were not measured, including failed ones among them. Such a row may be one failure, and is longer than a failure may be.</source>
        <translation>Odcinki, które następują po sobie bez przerwy i których nie zmierzono, wraz z niezgodnymi wśród nich. Taki ciąg może być usterką i jest dłuższy, niż usterka może być.</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/measure/messages.py" line="50"/>
        <source>the limits are {limits}</source>
        <translation>granice: {limits}</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/measure/messages.py" line="51"/>
        <source>{first}, {also}</source>
        <translation>{first}, {also}</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/measure/messages.py" line="52"/>
        <source>at least {limit:.0%} kept</source>
        <translation>zachowane co najmniej {limit:.0%}</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/measure/messages.py" line="53"/>
        <source>at most {limit:.2%} failed</source>
        <translation>najwyżej {limit:.2%} niezgodnych</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/measure/messages.py" line="55"/>
        <source>at least {limit:.1%} measured</source>
        <translation>zmierzone co najmniej {limit:.1%}</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/measure/messages.py" line="76"/>
        <source>the longest failure without a break is {value:.1f} m and the limit is {limit:.1f} m, but pieces are up to {metres:.1f} m long, which can hide a longer one</source>
        <translation>najdłuższa nieprzerwana usterka ma {value:.1f} m, a dopuszczalne jest {limit:.1f} m, lecz odcinki mają do {metres:.1f} m, co może ukryć dłuższą</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/measure/messages.py" line="96"/>
        <source>layers of seams whose mosaics are not given: {count} ({names})</source>
        <translation>warstwy linii mozaikowania dotyczą ortofotomap, których nie podano: {count} ({names})</translation>
    </message>
    <message>
        <location filename="../plugin/seams/words.py" line="267"/>
        <source>the sources were compressed with loss, and the mosaic holds more than they do</source>
        <translation>ortoobrazy skompresowano stratnie, a ortofotomapa zachowała więcej niż one</translation>
    </message>
    <message>
        <location filename="../plugin/imagery/messages.py" line="102"/>
        <source>something else is there</source>
        <translation>w tym miejscu jest coś innego</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/charts/chart_widgets.py" line="172"/>
        <source>Save picture</source>
        <translation>Zapisz obraz</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/charts/chart_widgets.py" line="187"/>
        <source>The picture was not saved to {path}: {error}. Choose another folder.</source>
        <translation>Nie zapisano obrazu w {path}: {error}. Wybierz inny katalog.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/charts/chart_widgets.py" line="190"/>
        <source>The picture was saved to {path}.</source>
        <translation>Zapisano obraz w {path}.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/charts/chart_widgets.py" line="183"/>
        <source>it can&apos;t be written</source>
        <translation>nie można go zapisać</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/dock.py" line="248"/>
        <source>The selected window at 2x, the mosaic beside its hard cut or a source, to judge the loss by eye</source>
        <translation>Zaznaczone okno w powiększeniu 2×, ortofotomapa obok ostrego cięcia albo ortoobrazu, do oceny straty okiem</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/map/hard_cut.py" line="72"/>
        <source>Open a source</source>
        <translation>Otwórz ortoobraz</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/images/images_panel.py" line="101"/>
        <source>What the mosaic is compared with</source>
        <translation>Z czym porównywana jest ortofotomapa</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/images/images_panel.py" line="192"/>
        <source>no source here</source>
        <translation>brak tu ortoobrazów</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/judge_bar.py" line="224"/>
        <source>Choose the operator, and judge blind.</source>
        <translation>Kto wydaje opinię: pierwszy czy drugi operator; w ciemno czy nie.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/judging.py" line="61"/>
        <source>{left} to go: {judged} of {count} judged</source>
        <translation>zostało {left}: {judged} z {count}</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/judging_desk.py" line="49"/>
        <source>Judge window after window: hides QGIS&apos;s panels and what lies over the mosaic (J); again: shows them as before</source>
        <translation>Ocena okno po oknie: panele QGIS ustępują miejsca, a to, co leży na ortofotomapie, znika (J); ponownie: wszystko jak przedtem</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/map/hard_cut.py" line="275"/>
        <source>hard cut: reading ...</source>
        <translation>ostre cięcie: wczytywanie...</translation>
    </message>
    <message>
        <location filename="../plugin/seams/measure/messages.py" line="369"/>
        <source>Covers the whole mosaic, as few others do: a copy of it, another mosaic or a map.</source>
        <translation>Pokrywa całą ortofotomapę, jak niewiele z pozostałych: jej kopia, inna ortofotomapa albo mapa.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/measure/messages.py" line="142"/>
        <source>Both operators judged {count} windows and agreed on {agreed}. Cohen&apos;s kappa {kappa:.2f}, 95 % interval {low:.2f} to {high:.2f}: 1 where they always agree, 0 where they do as often as by chance.</source>
        <translation>Obaj operatorzy ocenili {count} {count:okno|okna|okien}, zgodnie {agreed}. Kappa Cohena {kappa:.2f}, przedział ufności 95 % od {low:.2f} do {high:.2f}: 1, gdy są zawsze zgodni, 0, gdy tak często, jak przez przypadek.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/measure/window/window_tables.py" line="128"/>
        <source>code of the reason</source>
        <translation>kod powodu</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/paper/acceptance_report.py" line="100"/>
        <source>Seams: {verdict}</source>
        <translation>Linie mozaikowania: {verdict}</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/paper/acceptance_report.py" line="139"/>
        <source>seams that were not measured</source>
        <translation>linie mozaikowania, których nie zmierzono</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/paper/acceptance_report.py" line="145"/>
        <source>{count} {count:finding|findings}</source>
        <translation>{count} {count:ustalenie|ustalenia|ustaleń}</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/paper/acceptance_report.py" line="120"/>
        <source>; not judged: {bands}</source>
        <translation>; nie oceniono: {bands}</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/paper/acceptance_report.py" line="331"/>
        <source>{across} across</source>
        <translation>szerokość {across}</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/paper/acceptance_report.py" line="331"/>
        <source>a part of it, {across} across</source>
        <translation>fragment szerokości {across}</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/planinspection.py" line="33"/>
        <source>Draws a random sample of the seams of a delivery, proportionally from every sheet: as large as ISO 2859 requires, or as large as you choose. The sample comes as pieces of seam for &apos;Accept or reject a delivery&apos;, or as windows that open in the desk to be judged. The same seed draws the same sample.</source>
        <translation>Losuje próbę linii mozaikowania dostawy, proporcjonalnie z każdego arkusza: tak dużą, jak wymaga ISO 2859, albo jak podasz. Próba powstaje jako odcinki linii mozaikowania dla algorytmu „Przyjmij lub odrzuć dostawę” albo jako okna, które otwiera się w panelu do oceny. To samo ziarno losowania daje tę samą próbę.</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/planinspection.py" line="44"/>
        <source>How many: iso2859, as ISO 2859-1 says for a lot of a series; iso2859_2, as ISO 2859-2 says for an isolated lot; count, as many as you choose.</source>
        <translation>Liczność próby: iso2859 – według ISO 2859-1 dla partii w serii; iso2859_2 – według ISO 2859-2 dla partii izolowanej; count – taka, jaką podasz.</translation>
    </message>
    <message>
        <location filename="../plugin/photos/measure/messages.py" line="29"/>
        <source>The marks &apos;{mark}&apos; and &apos;{other}&apos; of the calibration are at the same place; correct their coordinates.</source>
        <translation>Znaczki „{mark}” i „{other}” kalibracji są w jednym miejscu; popraw ich współrzędne.</translation>
    </message>
    <message>
        <location filename="../plugin/photos/measure/messages.py" line="40"/>
        <source>The positions of &apos;{mark}&apos; and &apos;{other}&apos; are at the same place; move one of them.</source>
        <translation>Położenia „{mark}” i „{other}” są w jednym miejscu; przesuń jedno z nich.</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/measure/messages.py" line="35"/>
        <source>According to the image or its RPC the points&apos; columns and rows are swapped; swap the two fields.</source>
        <translation>Według obrazu lub jego RPC kolumny i wiersze punktów są zamienione; zamień oba pola.</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/measure/messages.py" line="46"/>
        <source>According to the image&apos;s RPC the points&apos; heights are in feet: as metres they miss it by {metres:.3g} px, as feet by {feet:.3g} px; give metres.</source>
        <translation>Według RPC obrazu wysokości punktów są w stopach: wzięte jako metry różnią się o {metres:.3g} px, jako stopy o {feet:.3g} px; podaj metry.</translation>
    </message>
    <message>
        <location filename="../plugin/toolkit/messages.py" line="66"/>
        <source>{name} has the wrong ending; the file is written as {filters}, so give it that ending.</source>
        <translation>{name} ma niewłaściwe rozszerzenie; plik jest zapisywany jako {filters}, więc nadaj mu takie rozszerzenie.</translation>
    </message>
    <message>
        <source>Shares refer to the measured metres. A piece counts in the sheet in which its middle lies.</source>
        <translation>Udziały odnoszą się do metrów, które zmierzono. Odcinek liczy się w arkuszu, w którym leży jego środek.</translation>
    </message>
    <message>
        <source>Failure {number}: {length}, least kept {kept}</source>
        <translation>Usterka {number}: {length}, najmniej zachowano {kept}</translation>
    </message>
    <message>
        <source>Checks the files of a delivery, scans its mosaic and decides on it, in one go: you give a folder or an index, and get one report with both on its cover, the record, the failures, and the sheets with their verdicts.</source>
        <translation>Kontroluje pliki dostawy, skanuje jej ortofotomapę i podejmuje decyzję w jednym przebiegu: podajesz katalog lub indeks, a dostajesz jeden raport z obiema kontrolami na okładce, zapis, usterki i arkusze z ich ocenami.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/dock.py" line="118"/>
        <source>Only look at them</source>
        <translation>Tylko je oglądam</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/dock.py" line="118"/>
        <source>Copy them</source>
        <translation>Skopiuj je</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/messages.py" line="23"/>
        <source>The windows in {name} are not in a windows file, so results and verdicts can&apos;t be saved with them. Copy them into one?</source>
        <translation>Okna w {name} nie są w pliku okien, więc nie można z nimi zachować pomiarów i ocen. Skopiować je do takiego pliku?</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/session.py" line="256"/>
        <source>removing window {number}</source>
        <translation>usunięcie okna {number}</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/session.py" line="256"/>
        <source>removing {count} windows</source>
        <translation>usunięcie okien: {count}</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/session.py" line="274"/>
        <source>judging window {number}</source>
        <translation>ocena okna {number}</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/session.py" line="274"/>
        <source>judging {count} windows</source>
        <translation>ocena okien: {count}</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/windows/new_windows.py" line="69"/>
        <source>drawing window {number}</source>
        <translation>narysowanie okna {number}</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/windows/new_windows.py" line="97"/>
        <source>adding {count} places of a scan</source>
        <translation>dodanie miejsc ze skanowania: {count}</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/windows/new_windows.py" line="141"/>
        <source>placing {count} windows</source>
        <translation>rozmieszczenie okien: {count}</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/windows/window_results.py" line="294"/>
        <source>inspecting window {number}</source>
        <translation>zbadanie okna {number}</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/windows/window_results.py" line="294"/>
        <source>inspecting {count} windows</source>
        <translation>zbadanie okien: {count}</translation>
    </message>
    <message>
        <location filename="../plugin/seams/measure/messages.py" line="59"/>
        <source>{path} can&apos;t be written ({error}); make sure that the disk has room and no other program has the file open.</source>
        <translation>Nie można zapisać {path} ({error}); zadbaj, aby na dysku było miejsce i żaden inny program nie miał otwartego tego pliku.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/measure/messages.py" line="135"/>
        <source>The layer {name} has no field &apos;{field}&apos;, which can&apos;t be added now: save its edits, then try again.</source>
        <translation>Warstwa {name} nie ma pola „{field}”, którego nie można teraz dodać: zapisz jej edycje i spróbuj ponownie.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/measure/window/window_tables.py" line="145"/>
        <source>origin</source>
        <translation>pochodzenie</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/measure/messages.py" line="15"/>
        <source>The seams lie outside the area of their coordinate reference system; assign them the system of their coordinates.</source>
        <translation>Linie mozaikowania leżą poza tym, co opisuje ich układ współrzędnych; należy im nadać układ, w którym są ich współrzędne.</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/measure/messages.py" line="257"/>
        <source>its pixels are {pixel:.3g} m instead of {wanted:.3g} m</source>
        <translation>piksel ma {pixel:.3g} m zamiast {wanted:.3g} m</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/measure/messages.py" line="258"/>
        <source>its reference system is {system} instead of {wanted}</source>
        <translation>ma układ odniesienia {system} zamiast {wanted}</translation>
    </message>
    <message>
        <location filename="../plugin/imagery/messages.py" line="32"/>
        <source>{name} is read in the reference system that was chosen for it, {system}, not in that of its file, {own}.</source>
        <translation>{name} jest brany w układzie współrzędnych, który mu wybrano, {system}, a nie w układzie swojego pliku, {own}.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/measure/messages.py" line="105"/>
        <source>{name} has a different pixel size from the mosaic&apos;s and was resampled; it is shown but not used, as others have the mosaic&apos;s pixel size.</source>
        <translation>{name} ma inną wielkość piksela niż ortofotomapa i został przepróbkowany; jest pokazany, ale się nie liczy, bo inne mają wielkość piksela ortofotomapy.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/measure/messages.py" line="294"/>
        <source>{metres:.0f} m of seam were found, but the orthoimages&apos; outlines are only {around:.0f} m long: the mosaic seems to change between them everywhere, as after warping by nearest neighbour. No seam is listed; give seamlines, or the mosaic as it was before.</source>
        <translation>Znaleziono {metres:.0f} m linii mozaikowania, a ortoobrazy mają razem {around:.0f} m obwodu: ortofotomapa zdaje się co chwilę przechodzić z jednego na drugi, jak po przekształceniu metodą najbliższego sąsiada. Nie wymieniono żadnej linii; należy podać linie mozaikowania albo ortofotomapę sprzed przekształcenia.</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/acceptmosaic.py" line="75"/>
        <source>Its reasons, in words</source>
        <translation>Uzasadnienie słowami</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/measure/messages.py" line="100"/>
        <source>some images given as orthoimages are the mosaic, or were made from others, so they hide what it lost: {names}</source>
        <translation>jako ortoobrazy podano obrazy, które są ortofotomapą albo powstały z innych, więc ukrywają to, co ona straciła: {names}</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/measure/messages.py" line="185"/>
        <source>What would decide it: a scan with the complete orthoimages as rectified, and no others.</source>
        <translation>Co by rozstrzygnęło: skanowanie z całymi ortoobrazami, tak jak powstały, i żadnymi innymi.</translation>
    </message>
    <message>
        <location filename="../plugin/imagery/messages.py" line="8"/>
        <source>{name} is not a raster that GDAL can read; check that it is complete, or save it as GeoTIFF.</source>
        <translation>{name} nie jest rastrem, który GDAL potrafi odczytać; sprawdź, czy plik jest kompletny, albo zapisz go jako GeoTIFF.</translation>
    </message>
    <message>
        <location filename="../plugin/imagery/messages.py" line="11"/>
        <source>{name} refers to {part}, which does not exist; restore that file, or make {name} again.</source>
        <translation>{name} składa się z pliku {part}, który nie istnieje; umieść go tam albo utwórz {name} od nowa.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/charts/profile_painter.py" line="126"/>
        <source>{kept} % kept ({low} to {high} %) in {width} m</source>
        <translation>zachowano {kept} % ({low} do {high} %) na {width} m</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/accept_page.py" line="267"/>
        <source>Save the decision</source>
        <translation>Zapisz decyzję</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/accept_page.py" line="317"/>
        <source>Decide</source>
        <translation>Rozstrzygnij</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/accept_page.py" line="317"/>
        <source>Decides in the background, by these limits.</source>
        <translation>Rozstrzyga w tle, według tych granic.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/accept_page.py" line="331"/>
        <source>Open report</source>
        <translation>Otwórz raport</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/accept_page.py" line="331"/>
        <source>The page to sign, in the browser.</source>
        <translation>Strona do podpisu, w przeglądarce.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/accept_page.py" line="333"/>
        <source>Failures on the map</source>
        <translation>Usterki na mapie</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/accept_page.py" line="333"/>
        <source>A line for each failure without a break.</source>
        <translation>Linia dla każdej nieprzerwanej usterki.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/accept_page.py" line="336"/>
        <source>Save as ...</source>
        <translation>Zapisz jako...</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/accept_page.py" line="336"/>
        <source>Report, failures with their pictures and quality record, into a folder.</source>
        <translation>Raport, usterki z obrazami i zapis jakości, do katalogu.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/accept_page.py" line="183"/>
        <source>Saved in {folder}.</source>
        <translation>Zapisano w {folder}.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/accept_page.py" line="218"/>
        <source>Not saved yet.</source>
        <translation>Jeszcze nie zapisano.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/accept_page.py" line="312"/>
        <source>Limits</source>
        <translation>Granice</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/accept_page.py" line="312"/>
        <source>Scans and their sheets</source>
        <translation>Badania i ich arkusze</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/judge_bar.py" line="61"/>
        <source>Judge here</source>
        <translation>Oceń tutaj</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/messages.py" line="7"/>
        <source>Windows are stored in your profile until the project is saved, then beside it. Now they are in {path}.</source>
        <translation>Okna są w Twoim profilu, dopóki projekt nie zostanie zapisany, potem obok niego. Teraz są w {path}.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/messages.py" line="20"/>
        <source>{path} exists already: choose another folder, so that no document is replaced.</source>
        <translation>{path} już istnieje: wybierz inny katalog, aby żaden dokument nie został zastąpiony.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/messages.py" line="21"/>
        <source>The decision could not be saved in {folder} ({error}); choose another folder.</source>
        <translation>Nie udało się zapisać decyzji w {folder} ({error}); wybierz inny katalog.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/measure/messages.py" line="218"/>
        <source>{outside:.0f} m of the {given:.0f} m of seamlines lie outside the mosaic, along the border of its pixels or within one orthoimage, where there is no seam, and are left out.</source>
        <translation>{outside:.0f} m z {given:.0f} m linii mozaikowania leży poza ortofotomapą, wzdłuż granicy jej pikseli albo wewnątrz jednego ortoobrazu, gdzie nie ma linii mozaikowania; zostały pominięte.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/measure/messages.py" line="222"/>
        <source>Along {metres:.0f} m of the seamlines, which name no orthoimage, the mosaic shows the same one on both sides: there is no seam, so they are left out.</source>
        <translation>Wzdłuż {metres:.0f} m linii mozaikowania, które niczego nie nazywają, ortofotomapa pokazuje po obu stronach ten sam ortoobraz: nie ma tam linii mozaikowania, więc zostały pominięte.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/measure/messages.py" line="242"/>
        <source>The orthoimages beside the seams are those that the seamline layer names in {fields}.</source>
        <translation>Ortoobrazy obok linii mozaikowania to te, które warstwa tych linii nazywa w polu {fields}.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/words.py" line="86"/>
        <source>at least {width}</source>
        <translation>co najmniej {width}</translation>
    </message>
    <message>
        <location filename="../plugin/toolkit/messages.py" line="40"/>
        <source>Dask {versions} answers at {address}, and this is Dask {own}; install the same version of dask and distributed on the scheduler, the workers and here.</source>
        <translation>Pod adresem {address} odpowiada Dask {versions}, a tutaj jest Dask {own}; zainstaluj tę samą wersję dask i distributed dla schedulera, procesów roboczych i tutaj.</translation>
    </message>
    <message>
        <location filename="../plugin/toolkit/messages.py" line="43"/>
        <source>{given} is not an executor; give one of concurrent.futures, a Dask client, or the address of a Dask scheduler.</source>
        <translation>{given} nie jest executorem; podaj executor z concurrent.futures, klienta Dask albo adres schedulera Dask.</translation>
    </message>
    <message>
        <location filename="../plugin/toolkit/messages.py" line="59"/>
        <source>In {path} field names are cut to ten letters ({names}), so they can&apos;t be found, or are mistaken for others; write a GeoPackage to keep them.</source>
        <translation>W pliku {path} nazwy pól są obcięte do dziesięciu liter ({names}), więc kto ich szuka, nie znajdzie ich albo znajdzie inne; zapisz GeoPackage, aby je zachować.</translation>
    </message>
    <message>
        <source>Kept by the worst piece, by distance from the seam</source>
        <translation>Zachowane w najgorszym odcinku, według odległości od linii</translation>
    </message>
    <message>
        <source>in a width of</source>
        <translation>na szerokości</translation>
    </message>
    <message>
        <location filename="../plugin/seams/measure/messages.py" line="428"/>
        <source>The seam does not name two of the given orthoimages; give those the mosaic was made from.</source>
        <translation>Linia mozaikowania nie wskazuje dwóch z podanych ortoobrazów; podaj te, z których powstała ortofotomapa.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/measure/messages.py" line="430"/>
        <source>The corridor is {value:g} m wide; give more than 0.</source>
        <translation>Korytarz ma szerokość {value:g} m; podaj więcej niż 0.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/measure/messages.py" line="431"/>
        <source>A blend of {value:g} pixels can&apos;t be made; give a whole number of 0 to {most}.</source>
        <translation>Wtapianie o szerokości {value:g} pikseli nie jest możliwe; podaj liczbę całkowitą od 0 do {most}.</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/measure/messages.py" line="155"/>
        <source>What would decide it: a scan with shorter pieces. Failures end within pieces, so with pieces of {piece:.0f} m the failed length is known only to {within:.0f} m, and {allowed:.0f} m may fail.</source>
        <translation>Co by rozstrzygnęło: skan z krótszymi odcinkami. Usterki kończą się wewnątrz odcinków, więc suma odcinków po {piece:.0f} m jest tu znana z dokładnością do {within:.0f} m, a niezgodnych może być {allowed:.0f} m.</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/measure/messages.py" line="171"/>
        <source>What would decide it: the files that were scanned, given as the mosaic and its orthoimages, or a new scan of the present files.</source>
        <translation>Co by rozstrzygnęło: skanowane pliki, podane jako ortofotomapa i jej ortoobrazy, albo skanowanie tych, które są teraz.</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/measure/messages.py" line="174"/>
        <source>What would decide it: all mosaics of the delivery given to the decision, each sheet or a VRT of all; leave the layers of others out.</source>
        <translation>Co by rozstrzygnęło: podanie do decyzji wszystkich ortofotomap dostawy, każdego arkusza albo pliku VRT z wszystkimi; pomiń warstwy innych.</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/measure/messages.py" line="177"/>
        <source>What would decide it: a scan with pieces of {piece:.0f} m or less, half of the longest failure that is allowed: a longer piece may pass although a part of it failed.</source>
        <translation>Co by rozstrzygnęło: skanowanie z odcinkami najwyżej {piece:.0f} m, połowa najdłuższej dopuszczalnej usterki: dłuższy odcinek zachowuje dość, choć jego część zawiodła.</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/measure/messages.py" line="189"/>
        <source>The layers of seams are of {count} mosaics, and none is given to the decision, so it is unknown whether all belong to the delivery.</source>
        <translation>Warstwy linii mozaikowania dotyczą {count} ortofotomap, a żadnej nie podano do decyzji: nie wiadomo, czy wszystkie należą do dostawy.</translation>
    </message>
    <message>
        <location filename="../plugin/imagery/messages.py" line="34"/>
        <source>&apos;{text}&apos; is not a projected or geographic coordinate reference system; write it as WKT, or as a code such as EPSG:2180.</source>
        <translation>„{text}” nie jest układem współrzędnych mapy (płaskim ani geograficznym); należy go zapisać jako WKT albo tak jak EPSG:2180.</translation>
    </message>
    <message>
        <location filename="../plugin/imagery/messages.py" line="50"/>
        <source>{name} is {value}; give {expected}.</source>
        <translation>{name}: podano {value}; należy podać {expected}.</translation>
    </message>
    <message>
        <location filename="../plugin/imagery/messages.py" line="52"/>
        <source>The window runs from {xmin:.8g} to {xmax:.8g} and from {ymin:.8g} to {ymax:.8g}; give xmin, ymin, xmax and ymax as numbers, the smaller ones first.</source>
        <translation>Okno biegnie od {xmin:.8g} do {xmax:.8g} i od {ymin:.8g} do {ymax:.8g}; podaj xmin, ymin, xmax i ymax jako liczby, najpierw mniejsze.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/measure/messages.py" line="109"/>
        <source>{path} holds no polygon on the mosaic that names its source; choose the layer of seam cells, with their sources&apos; file names in a field.</source>
        <translation>{path} nie zawiera na ortofotomapie wieloboku, który podaje swój ortoobraz; wskaż warstwę, w której są komórki ortofotomapy z nazwami plików ortoobrazów w polu.</translation>
    </message>
    <message>
        <location filename="../plugin/toolkit/layer_styles.py" line="45"/>
        <source>kept by distance from the seam</source>
        <translation>zachowane według odległości od linii łączenia</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/accept_page.py" line="307"/>
        <source>No mosaic is scanned yet: scan it, or run Accept delivery in the toolbox, which does.</source>
        <translation>Żadnej ortofotomapy jeszcze nie zbadano: zbadaj ją albo uruchom w panelu algorytmów Odbiór dostawy od plików, który to robi.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/charts/curves_tab.py" line="133"/>
        <source>Select one window to see its curves.</source>
        <translation>Zaznacz jedno okno, aby zobaczyć jego krzywe.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/dock.py" line="211"/>
        <source>Accept or reject the delivery by its scans</source>
        <translation>Przyjmij lub odrzuć dostawę według jej badań</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/dock.py" line="245"/>
        <source>How the variance of the selected window spreads over the levels of detail, and how much detail is kept by the distance from the seam</source>
        <translation>Jak wariancja zaznaczonego okna rozkłada się na poziomy detali i ile detali zachowano w zależności od odległości od linii mozaikowania</translation>
    </message>
    <message>
        <location filename="../plugin/seams/window_summary.py" line="90"/>
        <source>{clause} over {width} m</source>
        <translation>{clause} na szerokości {width} m</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/measure/messages.py" line="19"/>
        <source>A piece that has to keep 0 always passes; give the share that it has to keep, such as 0.7.</source>
        <translation>Odcinek, który ma zachować 0, jest zawsze zgodny; podaj część, którą ma zachować, np. 0,7.</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/measure/messages.py" line="214"/>
        <source>The layers of seams are empty, or none of their rows is a piece of seam (field &apos;level&apos;); choose the layers as the scans wrote them.</source>
        <translation>Warstwy linii mozaikowania są puste albo żaden ich wiersz nie jest odcinkiem linii (pole „level”); wybierz warstwy takie, jak je zapisało badanie.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/measure/messages.py" line="50"/>
        <source>Window {number} is not a rectangle; give (xmin, ymin, xmax, ymax), a geometry of shapely, or a row with a geometry or with xmin, ymin, xmax and ymax.</source>
        <translation>Okno {number} nie jest prostokątem; podaj (xmin, ymin, xmax, ymax), geometrię z shapely albo wiersz z geometrią lub z xmin, ymin, xmax i ymax.</translation>
    </message>
    <message>
        <location filename="../plugin/toolkit/messages.py" line="26"/>
        <source>&apos;{parameter}&apos; is {value:g}; give {least:g} or more.</source>
        <translation>„{parameter}” to {value:g}; podaj {least:g} lub więcej.</translation>
    </message>
    <message>
        <location filename="../plugin/toolkit/messages.py" line="27"/>
        <source>&apos;{parameter}&apos; is {value:g}; give a number from {least:g} to {most:g}.</source>
        <translation>„{parameter}” to {value:g}; podaj liczbę od {least:g} do {most:g}.</translation>
    </message>
    <message>
        <location filename="../plugin/toolkit/messages.py" line="28"/>
        <source>&apos;{parameter}&apos; is &apos;{value}&apos;; give one of {known}.</source>
        <translation>„{parameter}” to „{value}”; znane są {known}.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/measure/messages.py" line="24"/>
        <source>{name} does not lie on the pixel grid of {sheet}, or has other bands; give sheets of one mosaic as neighbours.</source>
        <translation>Raster {name} nie leży na siatce pikseli arkusza {sheet} albo ma inne kanały; jako sąsiednie podaj arkusze tej samej ortofotomapy.</translation>
    </message>
    <message>
        <location filename="../plugin/noise/measure/messages.py" line="17"/>
        <source>{share:.1%} of the window is invalid in one raster or another and {most:.0%} are allowed; choose another place.</source>
        <translation>Część okna bez danych w jednym z rastrów wynosi {share:.1%}, a dopuszcza się {most:.0%}; wybierz inne miejsce.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/measure/messages.py" line="132"/>
        <source>The table {table} has no field &apos;{field}&apos;; choose the one that &apos;Inspect windows&apos; left with these windows.</source>
        <translation>Tabela {table} nie ma pola „{field}”; wybierz tę, którą „Skontroluj okna” zostawiło z tymi oknami.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/words.py" line="140"/>
        <source>Feather less.</source>
        <translation>Wtapiaj węziej.</translation>
    </message>
    <message>
        <location filename="../plugin/imagery/messages.py" line="41"/>
        <source>The table has no lines; make a frame of it by to_dataframe().</source>
        <translation>Tabela nie zawiera linii; utwórz z niej ramkę danych metodą to_dataframe().</translation>
    </message>
    <message>
        <location filename="../plugin/seams/measure/messages.py" line="234"/>
        <source>{path} names no reference system, so it is taken in the mosaic&apos;s.</source>
        <translation>Plik {path} nie podaje układu współrzędnych, więc przyjęto układ ortofotomapy.</translation>
    </message>
    <message>
        <location filename="../plugin/imagery/messages.py" line="17"/>
        <source>{name} is read by GDAL&apos;s driver {driver}, which may open other files, a service or a database; save the part that is needed as GeoTIFF.</source>
        <translation>{name} czyta sterownik GDAL {driver}, który może prowadzić do innych plików, usługi lub bazy danych; zapisz potrzebną część jako GeoTIFF.</translation>
    </message>
    <message>
        <location filename="../plugin/imagery/messages.py" line="20"/>
        <source>{name} claims {columns} x {rows} px in blocks of {width} x {height} px, which no memory holds; save it again in tiles, or copy it again if it is damaged.</source>
        <translation>Raster {name} ma mieć {columns} × {rows} px w blokach {width} × {height} px, których nie pomieści żadna pamięć; zapisz go ponownie w kaflach albo, jeśli jest uszkodzony, skopiuj go ponownie.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/measure/messages.py" line="321"/>
        <source>{share:.0f} % of the mosaic&apos;s textured ground match none of the orthoimages, most of it around {x:.1f}, {y:.1f}, so nothing is measured there. Give those that it was made from, and check that they lie where it does.</source>
        <translation>{share:.0f} % terenu ortofotomapy z teksturą nie odpowiada żadnemu ortoobrazowi, najwięcej przy {x:.1f}; {y:.1f}, więc niczego tam nie zmierzono. Podaj te, z których ją tam wykonano, i sprawdź, czy leżą tam, gdzie ortofotomapa.</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/measure/messages.py" line="54"/>
        <source>at most {limit:.1f} m without a break</source>
        <translation>najwyżej {limit:.1f} m bez przerwy</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/measure/messages.py" line="123"/>
        <source>{nonconforming} of {inspected} inspected pieces failed, at most {limit} may</source>
        <translation>niezgodnych odcinków w skontrolowanej próbie ({inspected}) jest {nonconforming}, a dopuszcza się {limit}</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/measure/messages.py" line="224"/>
        <source>The layer &apos;{name}&apos; can&apos;t be written; choose another folder, and close the file where it is open.</source>
        <translation>Nie można zapisać warstwy „{name}”; wybierz inny katalog i zamknij plik tam, gdzie jest otwarty.</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/measure/messages.py" line="245"/>
        <source>The run was stopped: there is neither report nor XML, and the failures may have no pictures.</source>
        <translation>Przerwano: nie ma ani raportu, ani XML, a usterki mogą nie mieć obrazów.</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/paper/acceptance_report.py" line="200"/>
        <source>found: {judged}</source>
        <translation>znalezione: {judged}</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/paper/acceptance_report.py" line="202"/>
        <source>; found and not given: {unseen}, given and not found: {unchanged}</source>
        <translation>; znalezione, a niepodane: {unseen}, podane, a nieznalezione: {unchanged}</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/paper/acceptance_report.py" line="203"/>
        <source>; borders without a measured seam: {unseen}</source>
        <translation>; granice bez zmierzonej linii: {unseen}</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/measure/messages.py" line="59"/>
        <source>sampled at level {level}, AQL {aql:g}</source>
        <translation>próba według poziomu {level}, AQL {aql:g}</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/measure/messages.py" line="60"/>
        <source>sampled as an isolated lot, LQ {lq:g} %</source>
        <translation>próba z partii izolowanej, LQ {lq:g} %</translation>
    </message>
    <message>
        <source>Dashes mark the failure, the frame the middle of the piece that kept least. Beside it at 2x: the mosaic, its orthoimages cut hard, and each orthoimage; marks at the edges show the seam, chequers ground without data. The curve is what the scan measured of that piece: grey is the judged strip, the thick line what is kept in it, red the limit.</source>
        <translation>Linia przerywana biegnie wzdłuż usterki, w ramce jest środek odcinka, który zachował najmniej. Obok w powiększeniu 2×: ortofotomapa, jej ortoobrazy cięte ostro i każdy ortoobraz; znaki na krawędziach wskazują linię mozaikowania, szachownica brak danych. Krzywa to pomiar tego odcinka przez skanowanie: szary jest oceniany pas, gruba linia to, co się w nim zachowało, czerwona to granica.</translation>
    </message>
    <message>
        <location filename="../plugin/imagery/messages.py" line="44"/>
        <source>Some places can&apos;t be transformed to another coordinate reference system; check the systems of the layers.</source>
        <translation>Niektórych położeń nie da się przeliczyć do innego układu współrzędnych; sprawdź układy warstw.</translation>
    </message>
    <message>
        <location filename="../plugin/imagery/messages.py" line="98"/>
        <source>{name} can&apos;t be read over the network ({why}); check its address, the network, and GDAL&apos;s settings and credentials, or copy it to a local disk.</source>
        <translation>Nie można odczytać {name} przez sieć ({why}); sprawdź adres, sieć oraz ustawienia i dane logowania GDAL albo skopiuj plik na dysk lokalny.</translation>
    </message>
    <message>
        <location filename="../plugin/toolkit/packages.py" line="41"/>
        <source>Run &apos;{command}&apos; with the Python that QGIS uses (on Windows in the OSGeo4W shell), then restart QGIS. Or let the plugin QPIP install the packages in requirements.txt in the plugin&apos;s folder.</source>
        <translation>Uruchom „{command}” w Pythonie, którego używa QGIS (w systemie Windows w OSGeo4W Shell), a potem uruchom ponownie QGIS. Albo niech wtyczka QPIP zainstaluje to, co wymienia requirements.txt w katalogu wtyczki.</translation>
    </message>
    <message>
        <location filename="../plugin/toolkit/messages.py" line="57"/>
        <source>&apos;{output}&apos; can&apos;t be {path}: &apos;{found}&apos; means something else there to QGIS or GDAL; choose another name.</source>
        <translation>&apos;{output}&apos; nie może być plikiem {path}: &apos;{found}&apos; znaczy tam dla QGIS lub GDAL co innego; wybierz inną nazwę.</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/checkdelivery.py" line="37"/>
        <source>Checks the files of a delivery before their seams: sheets that are missing, were not ordered, have no data inside their outline, can&apos;t be read, or hide each other; pixel size, reference system, bands, type of the pixels and names. Writes the sheets with their findings, ready for &apos;Accept or reject a delivery&apos;, and one mosaic over all that were ordered, ready for the scan.</source>
        <translation>Sprawdza pliki dostawy przed jej liniami mozaikowania: arkusze, których brakuje, których nikt nie zamówił, które nie mają danych wewnątrz swojego obrysu, których nie da się odczytać albo które zasłaniają się nawzajem; rozmiar piksela, układ odniesienia, kanały, typ pikseli i nazwy. Zapisuje arkusze z uwagami do każdego, gotowe dla odbioru dostawy, oraz jedną ortofotomapę wszystkich zamówionych, gotową do skanowania.</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/measure/messages.py" line="26"/>
        <source>{parameter} is {value}, and the rules in {name} are given, too; leave it at its default, or leave the rules out.</source>
        <translation>{parameter} wynosi {value}, a podano też reguły w pliku {name}; zostaw wartość domyślną albo nie podawaj reguł.</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/measure/messages.py" line="45"/>
        <source>Accepted by &apos;{rules}&apos;: {why}.</source>
        <translation>Przyjęto według „{rules}”: {why}.</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/measure/messages.py" line="46"/>
        <source>Rejected by &apos;{rules}&apos;: {why}.</source>
        <translation>Odrzucono według „{rules}”: {why}.</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/measure/messages.py" line="47"/>
        <source>Undecided by &apos;{rules}&apos;: {why}.</source>
        <translation>Nie rozstrzygnięto według „{rules}”: {why}.</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/measure/messages.py" line="90"/>
        <source>sheets that differ from others where they overlap, which nobody has checked: {count} ({names})</source>
        <translation>arkusze, które nachodzą na inne i pokazują tam coś innego, czego nikt nie obejrzał: {count} ({names})</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/measure/messages.py" line="92"/>
        <source>different scans of one mosaic are given: {count} ({names})</source>
        <translation>podano różne skany tej samej ortofotomapy: {count} ({names})</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/measure/messages.py" line="94"/>
        <source>the files given are not the ones that were scanned: {count} ({names})</source>
        <translation>podano pliki, które nie są tymi, które skanowano: {count} ({names})</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/measure/messages.py" line="146"/>
        <source>What would decide it: measuring at least {wanted:.0f} of the {lacking:.0f} m that were not measured. Give the orthoimages beside them to the scan.</source>
        <translation>Co by rozstrzygnęło: wyniki dla co najmniej {wanted:.0f} z {lacking:.0f} m, których nie zmierzono. Podaj do skanowania ortoobrazy po ich bokach.</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/measure/messages.py" line="180"/>
        <source>What would decide it: a scan of all sheets, complete, readable and identical where they overlap; leave out the layer of a sheet without seams.</source>
        <translation>Co by rozstrzygnęło: skan wszystkich arkuszy, całych i jednakowych tam, gdzie na siebie nachodzą, który potrafi każdy z nich odczytać; pomiń warstwę arkusza bez linii mozaikowania.</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/measure/messages.py" line="262"/>
        <source>it does not show the same as {names} where they overlap</source>
        <translation>tam, gdzie nachodzi na {names}, pokazuje co innego</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/paper/paper_head.py" line="56"/>
        <source>The orthoimages: the report shows each failure beside the two that meet there and their cut. Empty: those that were scanned.</source>
        <translation>Ortoobrazy jako dowód: każda usterka jest pokazana obok dwóch, które się tam stykają, i ich ostrego cięcia. Puste: te, które skanowano.</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/planinspection.py" line="40"/>
        <source>The layers &apos;Seams&apos; of the scans of one delivery, a sheet each.</source>
        <translation>Warstwy „Odcinki linii mozaikowania” z badań jednej dostawy, po jednej na arkusz.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/charts/curves_painter.py" line="282"/>
        <source>and {count} more</source>
        <translation>i {count} więcej</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/charts/curves_tab.py" line="47"/>
        <source>The composite is what a hard cut of the sources along the seam, levelled to the mosaic&apos;s tone, would have. On or below the limit a loss is significant by curves.</source>
        <translation>Kompozycja to to, co miałoby ostre cięcie ortoobrazów wzdłuż linii, wyrównane do tonu ortofotomapy. Na granicy lub pod nią utrata jest istotna według krzywych.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/windows/window_columns.py" line="121"/>
        <source>Detail at level 1 in the mosaic as a multiple of the least sharp source&apos;s.</source>
        <translation>Stosunek wariancji detali na poziomie 1: ortofotomapa względem najmniej ostrego ortoobrazu źródłowego.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/windows/windows_panel.py" line="114"/>
        <source>A click goes to a window on the map, Enter once more; Del removes the selected ones.</source>
        <translation>Kliknięcie przenosi mapę do okna, Enter ponownie; Del usuwa zaznaczone.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/measure/messages.py" line="7"/>
        <source>{name} is {limit}; give a number between 0 and 1.</source>
        <translation>{name} wynosi {limit}; podaj liczbę od 0 do 1.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/measure/messages.py" line="170"/>
        <source>{measure}: no threshold is better than a guess; look at the verdicts again, or use another measure.</source>
        <translation>{measure}: żaden próg nie jest lepszy od zgadywania; przejrzyj opinie jeszcze raz albo użyj innej miary.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/measure/messages.py" line="173"/>
        <source>{measure}: the verdicts support a threshold of {threshold:.3f}, but it has to be below {most:g} to be set.</source>
        <translation>{measure}: opinie wskazują próg {threshold:.3f}, a można ustawić tylko mniejszy niż {most:g}.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/measure/messages.py" line="389"/>
        <source>{name} shows what other sources show, with less detail, as a blurred mosaic or a mean of orthoimages does. It hides losses, so remove it from the sources.</source>
        <translation>{name} pokazuje to, co inne źródła, z mniejszą ilością szczegółów, jak rozmyta ortofotomapa albo średnia ortoobrazów. Ukrywa straty, więc usuń go ze źródeł.</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/measure/messages.py" line="118"/>
        <source>Several of a model file, an RPC file and a photo&apos;s orientation are given; choose one of them.</source>
        <translation>Podano kilka spośród: plik modelu, plik RPC i orientacja zdjęcia; wybierz jedno z nich.</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/measure/messages.py" line="132"/>
        <source>Angles of {name} reach {angle:.6g} and are taken as degrees; if they are in {unit}, set their unit.</source>
        <translation>Kąty w {name} sięgają {angle:.6g} i są brane jako stopnie; jeśli ich jednostką jest {unit}, ustaw ją.</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/measure/messages.py" line="39"/>
        <source>A piece of the sample does not lie on the mosaic; give that of all sheets, and check the reference systems.</source>
        <translation>Odcinek próby nie leży na ortofotomapie; podaj tę, która obejmuje wszystkie arkusze, i sprawdź układy odniesienia.</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/measure/messages.py" line="183"/>
        <source>What would decide it: one scan of each mosaic, and of sheets that overlap as one mosaic.</source>
        <translation>Co by rozstrzygnęło: jeden skan każdej ortofotomapy, a arkuszy, które się nakładają, jako jednej ortofotomapy.</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/measure/messages.py" line="210"/>
        <source>{name} can&apos;t be read as a layer of lines; choose the layer &apos;Seams&apos; of a scan.</source>
        <translation>{name}: nie można odczytać jako warstwy linii; wybierz warstwę „Odcinki linii mozaikowania” ze skanu.</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/planinspection.py" line="53"/>
        <source>What windows are placed on. With the same seed, windows and pieces are the same sample.</source>
        <translation>Na czym rozmieszczane są okna. Przy tym samym ziarnie losowania okna i odcinki tworzą jedną próbę.</translation>
    </message>
    <message>
        <source>SHA-256 of its rows</source>
        <translation>SHA-256 wierszy</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/paper/paper_head.py" line="22"/>
        <source>As it is to stand on paper: 2026-11-23.</source>
        <translation>Tak, jak ma stać na papierze: 2026-11-23.</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/paper/quality_document.py" line="136"/>
        <source>Sheets that are missing, incomplete, or differ from most sheets or from the order.</source>
        <translation>Arkusze brakujące, niepełne albo o innej postaci niż większość lub niż zamówiono.</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/paper/quality_document.py" line="137"/>
        <source>The files of all sheets (&apos;Check a delivery&apos;).</source>
        <translation>Pliki wszystkich arkuszy („Sprawdź dostawę”).</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/paper/quality_document.py" line="138"/>
        <source>form of the delivery</source>
        <translation>postać dostawy</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/measure/messages.py" line="230"/>
        <source>Without what a scan with orthoimages found on the ground, seams that are in no row are unknown: {names}.</source>
        <translation>Bez tego, co o terenie mówi skanowanie z ortoobrazami, nic nie wiadomo o liniach mozaikowania, których nie ma w żadnym wierszu: {names}.</translation>
    </message>
    <message>
        <location filename="../plugin/imagery/messages.py" line="29"/>
        <source>{name} has no coordinate reference system (CRS); set it where the raster is opened, or write it into the file.</source>
        <translation>Raster {name} nie ma układu współrzędnych (CRS); ustaw go tam, gdzie raster jest otwierany, albo zapisz go w pliku.</translation>
    </message>
    <message>
        <location filename="../plugin/imagery/messages.py" line="54"/>
        <source>The window lies outside the mosaic; choose a place on it.</source>
        <translation>Okno leży poza ortofotomapą; wybierz miejsce na niej.</translation>
    </message>
    <message>
        <location filename="../plugin/imagery/messages.py" line="56"/>
        <source>The window covers {width} x {height} px of the mosaic; a side needs at least {fewest} px, so take a larger one, or use fewer levels where these ask for more than 64 px.</source>
        <translation>Okno obejmuje {width} × {height} px ortofotomapy, a bok musi mieć co najmniej {fewest} px; weź większe okno albo, jeśli poziomy wymagają więcej niż 64 px, zmniejsz ich liczbę.</translation>
    </message>
    <message>
        <location filename="../plugin/imagery/messages.py" line="59"/>
        <source>The window covers {width} x {height} px of the mosaic, but {most} million px are the most; take a smaller one.</source>
        <translation>Okno obejmuje {width} × {height} px ortofotomapy, a może mieć najwyżej {most} mln px; weź mniejsze okno.</translation>
    </message>
    <message>
        <location filename="../plugin/imagery/messages.py" line="74"/>
        <source>The seamline layer holds no line and no polygon; give that of the mosaic&apos;s seamlines or of its source polygons.</source>
        <translation>Warstwa linii mozaikowania nie zawiera linii ani poligonów; podaj warstwę linii mozaikowania ortofotomapy albo poligonów jej ortoobrazów źródłowych.</translation>
    </message>
    <message>
        <location filename="../plugin/imagery/messages.py" line="83"/>
        <source>The geometry of feature {feature} in the seamline layer can&apos;t be read; repair it (&apos;Fix geometries&apos; or ogr2ogr -makevalid).</source>
        <translation>Nie można odczytać geometrii obiektu {feature} w warstwie linii mozaikowania; napraw ją („Napraw geometrie” albo ogr2ogr -makevalid).</translation>
    </message>
    <message>
        <location filename="../plugin/imagery/messages.py" line="86"/>
        <source>The seamline layer has coordinates that are not numbers in the mosaic&apos;s reference system; check the reference systems of both and repair the layer (&apos;Fix geometries&apos; or ogr2ogr -makevalid).</source>
        <translation>Warstwa linii mozaikowania zawiera współrzędne, które na mapie ortofotomapy nie są liczbami; sprawdź układy współrzędnych obu i napraw warstwę („Napraw geometrie” albo ogr2ogr -makevalid).</translation>
    </message>
    <message>
        <location filename="../plugin/noise/measure/messages.py" line="41"/>
        <source>The curve rises, but the window is too small to tell noise coarser than a pixel (grain) from texture; take a larger one.</source>
        <translation>Krzywa rośnie, ale okno jest za małe, aby odróżnić szum grubszy niż piksel (ziarno) od tekstury; weź większe.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/charts/profile_painter.py" line="107"/>
        <source>beyond {near} m: {kept} % kept ({low} to {high} %)</source>
        <translation>dalej niż {near} m: zachowane {kept} % (od {low} do {high} %)</translation>
    </message>
    <message>
        <location filename="../plugin/seams/charts/profile_painter.py" line="108"/>
        <source>{near} to {far} m: {kept} % kept ({low} to {high} %)</source>
        <translation>od {near} do {far} m: zachowane {kept} % (od {low} do {high} %)</translation>
    </message>
    <message>
        <location filename="../plugin/seams/charts/profile_painter.py" line="113"/>
        <source>{near} to {far} m: {kept} % kept ({low} to {high} %), {other} % other image</source>
        <translation>od {near} do {far} m: zachowane {kept} % (od {low} do {high} %), {other} % drugiego obrazu</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/charts/chart_widgets.py" line="157"/>
        <source>Save the chart as a picture</source>
        <translation>Zapisz wykres jako obraz</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/dock.py" line="63"/>
        <source>Click: selects the window under the mouse (Shift adds it), or makes a standard window, on the seam when one is near. Drag: a rectangle. Ctrl+click: a window on top of another.</source>
        <translation>Kliknięcie: zaznacza okno w tym miejscu, z klawiszem Shift jako kolejne; gdy go tam nie ma, tworzy okno standardowe, w pobliżu linii mozaikowania umieszczane na niej. Przeciągnięcie: prostokąt. Ctrl+kliknięcie: okno na innym oknie.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/judge_bar.py" line="163"/>
        <source>{count} windows selected.</source>
        <translation>Zaznaczono {count} {count:okno|okna|okien}.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/mosaic_scans.py" line="112"/>
        <source>Scan: putting the blocks together</source>
        <translation>Badanie: łączenie bloków</translation>
    </message>
    <message>
        <location filename="../plugin/seams/measure/messages.py" line="208"/>
        <source>None of the orthoimages can be used, for the reasons told before; fix that, or leave them all out to scan the mosaic along its seamlines alone.</source>
        <translation>Żadnego z ortoobrazów nie można użyć, z podanych przyczyn; usuń te przyczyny albo nie podawaj żadnych ortoobrazów, aby zbadać samą ortofotomapę wzdłuż jej linii mozaikowania.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/measure/messages.py" line="248"/>
        <source>Features of the seamline layer whose geometry can&apos;t be read, left out: {count}; repair it (&apos;Fix geometries&apos; or ogr2ogr -makevalid).</source>
        <translation>Pominięte obiekty warstwy linii mozaikowania, których geometrii nie można odczytać: {count}; napraw ją („Napraw geometrie” albo ogr2ogr -makevalid).</translation>
    </message>
    <message>
        <location filename="../plugin/toolkit/messages.py" line="36"/>
        <source>A Dask scheduler was given but Dask is not installed; install &apos;dask[distributed]&apos;, or give no scheduler.</source>
        <translation>Podano scheduler Dask, ale pakiet Dask nie jest zainstalowany; zainstaluj „dask[distributed]” albo nie podawaj schedulera.</translation>
    </message>
    <message>
        <location filename="../plugin/toolkit/messages.py" line="38"/>
        <source>No Dask scheduler answers at {address} ({error}); check the address (the usual port is 8786), or give none.</source>
        <translation>Pod adresem {address} nie odpowiada scheduler Dask ({error}); sprawdź adres (zwykle z portem 8786) albo nie podawaj żadnego.</translation>
    </message>
    <message>
        <location filename="../plugin/toolkit/messages.py" line="45"/>
        <source>The executor was shut down or lost its workers; open a new one, then run this again. A script whose processes are spawned needs the line if __name__ == &apos;__main__&apos;: above its work.</source>
        <translation>Executor zamknięto albo stracił swoje procesy; otwórz nowy i uruchom to ponownie. Skrypt, którego procesy są uruchamiane od nowa (spawn), musi mieć nad swoimi poleceniami wiersz if __name__ == &apos;__main__&apos;:.</translation>
    </message>
    <message>
        <location filename="../plugin/toolkit/messages.py" line="50"/>
        <source>The workers of the Dask scheduler at {address} lack {packages} in their Python; install it there (osgeo is GDAL&apos;s python3-gdal), or give no scheduler.</source>
        <translation>W Pythonie procesów roboczych schedulera Dask pod adresem {address} brakuje: {packages}; zainstaluj to tam (osgeo to python3-gdal z GDAL) albo nie podawaj schedulera.</translation>
    </message>
    <message>
        <source>The windows by their verdicts; the numbers are theirs.</source>
        <translation>Okna według ocen, z ich numerami.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/measure/messages.py" line="93"/>
        <source>Both orthoimages show the very same pixels along the seam, and not farther off: they were changed there, or are parts of a single image. Ask for the orthoimages as they were before the mosaic was made.</source>
        <translation>Oba ortoobrazy mają wzdłuż linii te same piksele, a dalej od niej już nie: zmieniono je tam albo są częściami jednego obrazu. Poproś o ortoobrazy sprzed wykonania ortofotomapy.</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/measure/messages.py" line="149"/>
        <source>What would decide it: an operator&apos;s look, by which whoever signs decides, since all seams lie on ground without detail.</source>
        <translation>Co by rozstrzygnęło: obejrzenie przez operatora, na którego podstawie rozstrzyga ten, kto podpisuje, bo wszystkie linie mozaikowania leżą na terenie bez szczegółów.</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/measure/messages.py" line="152"/>
        <source>What would decide it: an operator&apos;s look at the pieces whose intervals include the limit ({metres:.0f} m, pieces: {count}); whoever signs decides by that.</source>
        <translation>Co by rozstrzygnęło: obejrzenie przez operatora odcinków, których przedziały obejmują próg ({metres:.0f} m, odcinków: {count}); na tej podstawie rozstrzyga ten, kto podpisuje.</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/measure/messages.py" line="48"/>
        <source>Open besides: {why}.</source>
        <translation>Nierozstrzygnięte są też: {why}.</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/measure/messages.py" line="106"/>
        <source>orthoimages that the seamlines name were not given to the scan ({names}), so seams beside them are not measured</source>
        <translation>skanowanie nie miało ortoobrazów, które wymieniają linie mozaikowania ({names}), więc linii obok nich nie zmierzono</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/measure/messages.py" line="159"/>
        <source>What would decide it: as many measured pieces as the plan needs, drawn from the whole lot.</source>
        <translation>Co by rozstrzygnęło: tyle zmierzonych odcinków, ile wymaga plan, wylosowanych z całej partii.</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/paper/acceptance_report.py" line="118"/>
        <source>Judged in the luminance of the bands {bands}</source>
        <translation>Oceniano luminancję kanałów {bands}</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/paper/acceptance_report.py" line="118"/>
        <source>Judged in the band {bands}</source>
        <translation>Oceniano kanał {bands}</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/measure/messages.py" line="56"/>
        <source>no limit on the share that failed</source>
        <translation>bez progu dla udziału niezgodnych</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/measure/messages.py" line="57"/>
        <source>no limit on metres without a break</source>
        <translation>bez progu dla metrów bez przerwy</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/measure/messages.py" line="58"/>
        <source>no limit on the share measured</source>
        <translation>bez progu dla udziału zmierzonych</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/paper/acceptance_report.py" line="239"/>
        <source>no limit</source>
        <translation>bez progu</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/paper/acceptance_report.py" line="239"/>
        <source>does not decide</source>
        <translation>nie rozstrzyga</translation>
    </message>
    <message>
        <source>kept by its pieces, from north to south: {pieces}</source>
        <translation>zachowane w kolejnych odcinkach, z północy na południe: {pieces}</translation>
    </message>
    <message>
        <source>kept by its pieces, from south to north: {pieces}</source>
        <translation>zachowane w kolejnych odcinkach, z południa na północ: {pieces}</translation>
    </message>
    <message>
        <source>kept by its pieces, from west to east: {pieces}</source>
        <translation>zachowane w kolejnych odcinkach, z zachodu na wschód: {pieces}</translation>
    </message>
    <message>
        <source>kept by its pieces, from east to west: {pieces}</source>
        <translation>zachowane w kolejnych odcinkach, ze wschodu na zachód: {pieces}</translation>
    </message>
    <message>
        <location filename="../plugin/seams/charts/profile_painter.py" line="111"/>
        <source>{near} to {far} m: {kept} % kept</source>
        <translation>{near} do {far} m: zachowano {kept} %</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/judge_bar.py" line="62"/>
        <source>Goes to the window on this piece of seam, or makes one, and inspects it.</source>
        <translation>Przechodzi do okna na tym odcinku linii mozaikowania albo tworzy je i mierzy.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/messages.py" line="15"/>
        <source>The layer {name} stays in {old}, as it can&apos;t be moved to {folder} ({error}); export it from there.</source>
        <translation>Warstwa {name} zostaje w {old}, bo nie można jej przenieść do {folder} ({error}); wyeksportuj ją stamtąd.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/messages.py" line="19"/>
        <source>Windows of this mosaic were restored. The project lacked them; they are in {path}.</source>
        <translation>Przywrócono okna tej ortofotomapy. Projekt ich nie miał; są w {path}.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/mosaic_scans.py" line="265"/>
        <source>Inspects the windows of the worst places, and goes to the worst that is not judged yet.</source>
        <translation>Kontroluje okna w najgorszych miejscach i przechodzi do najgorszego, które nie jest jeszcze ocenione.</translation>
    </message>
    <message>
        <source>F</source>
        <translation>U</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/judging.py" line="71"/>
        <source>{count} not comparable or not inspected</source>
        <translation>nieporównywalne lub nieskontrolowane: {count}</translation>
    </message>
    <message>
        <location filename="../plugin/toolkit/messages.py" line="64"/>
        <source>{path} is unchanged, as the run did not finish or another program has the file open; the new layer is {part}.</source>
        <translation>{path} pozostaje bez zmian, bo obliczeń nie ukończono albo plik jest otwarty w innym programie; nowa warstwa to {part}.</translation>
    </message>
    <message>
        <location filename="../plugin/photos/measure/messages.py" line="109"/>
        <source>The folder {path} does not exist, or holds neither layers with a field &apos;mark&apos; nor MicMac&apos;s MeasuresIm-*.xml.</source>
        <translation>Katalog {path} nie istnieje albo nie zawiera ani warstw z polem „mark”, ani plików MeasuresIm-*.xml programu MicMac.</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/measure/messages.py" line="83"/>
        <source>the mosaic of &apos;{name}&apos; does not lie where its orthoimages do: it lies {east:+.2f} m to the east, {north:+.2f} m to the north of all of them</source>
        <translation>ortofotomapa „{name}” nie leży tam, gdzie jej ortoobrazy, lecz {east:+.2f} m na wschód i {north:+.2f} m na północ od nich wszystkich</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/measure/messages.py" line="85"/>
        <source>{share:.2%} of the mosaic of &apos;{name}&apos; could not be read, such as around {place}</source>
        <translation>nie udało się odczytać {share:.2%} ortofotomapy „{name}”, na przykład wokół {place}</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/measure/messages.py" line="160"/>
        <source>What would decide it: a scan with the orthoimages that are missing.</source>
        <translation>Co by rozstrzygnęło: skanowanie z brakującymi ortoobrazami.</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/measure/messages.py" line="162"/>
        <source>What would decide it: a scan of mosaic and orthoimages that lie in the same place. Ask the producer which of them have a wrong georeference.</source>
        <translation>Co by rozstrzygnęło: badanie ortofotomapy i ortoobrazów, które leżą w tym samym miejscu. Zapytaj wykonawcę, które z nich mają błędną georeferencję.</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/measure/messages.py" line="232"/>
        <source>Only {share:.0%} of the mosaic of &apos;{name}&apos; were scanned, in its corridor; seams elsewhere are unknown.</source>
        <translation>W „{name}” obejrzano {share:.0%} ortofotomapy, w obrębie korytarza; linie mozaikowania poza nim nie są znane.</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/measure/messages.py" line="239"/>
        <source>The scan of &apos;{name}&apos; measured along the seamlines that it was given; a seam that these lack is noticed only if it is longer than some 150 pixels.</source>
        <translation>Skanowanie „{name}” mierzyło wzdłuż linii mozaikowania, które mu podano; brakującą widać tylko wtedy, gdy jest dłuższa niż około 150 pikseli.</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/paper/acceptance_report.py" line="255"/>
        <source>pieces not measured</source>
        <translation>odcinki niezmierzone</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/paper/acceptance_report.py" line="211"/>
        <source>; most of it around {place}</source>
        <translation>; najwięcej przy {place}</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/charts/curves_tab.py" line="80"/>
        <source>Live: {columns} x {rows} px</source>
        <translation>Na żywo: {columns} × {rows} px</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/inputs/inputs_panel.py" line="169"/>
        <source>{asked} m does not fit this mosaic: {side} m now, a window every {spacing} m</source>
        <translation>{asked} m nie pasuje do tej ortofotomapy: teraz {side} m, okno co {spacing} m</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/report_writer.py" line="85"/>
        <source>{count} have no curves in it: inspect them again.</source>
        <translation>{count} {count:okno|okna|okien} nie ma w nim krzywych: skontroluj je ponownie.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/windows/windows_panel.py" line="121"/>
        <source>Shows the windows whose number, verdict, cause, observer, origin (scan) or reason matches.</source>
        <translation>Pokazuje okna, których numer, ocena, przyczyna, obserwator, pochodzenie (scan) lub powód pasuje.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/measure/messages.py" line="325"/>
        <source>The mosaic does not lie where its orthoimages do: it lies {east:+.2f} m to the east, {north:+.2f} m to the north of all of them, so {share:.0f} % of its textured ground match none. Ask which of them have a wrong georeference.</source>
        <translation>Ortofotomapa nie leży tam, gdzie jej ortoobrazy, lecz {east:+.2f} m na wschód i {north:+.2f} m na północ od nich wszystkich, więc {share:.0f} % jej terenu z teksturą nie odpowiada żadnemu. Zapytaj, które z nich mają błędną georeferencję.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/window_summary.py" line="85"/>
        <source>images {value} px apart</source>
        <translation>obrazy przesunięte o {value} px</translation>
    </message>
    <message>
        <location filename="../plugin/seams/words.py" line="196"/>
        <source>images do not fit</source>
        <translation>obrazy nie pasują do siebie</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/measure/messages.py" line="12"/>
        <source>{name} holds no sound ground control points; choose a layer or a file of points.</source>
        <translation>{name} nie zawiera poprawnych fotopunktów; wybierz warstwę albo plik z punktami.</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/measure/messages.py" line="23"/>
        <source>it has no height, and no terrain model has one there.</source>
        <translation>nie ma wysokości i nie ma jej tam żaden NMT.</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/measure/messages.py" line="59"/>
        <source>There are {count} control points and the model {model} needs at least {fewest}; measure more, lower the share of check points, or choose a model with fewer unknowns.</source>
        <translation>{count:Jest|Są|Jest} {count} {count:fotopunkt|fotopunkty|fotopunktów}, a model {model} wymaga co najmniej {fewest}; zmierz więcej punktów, zmniejsz udział punktów kontrolnych albo wybierz model o mniejszej liczbie niewiadomych.</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/measure/messages.py" line="90"/>
        <source>The model can&apos;t be fitted to these points; check for interchanged coordinates or wrong heights, look for blunders (ROBUST), or choose a model with fewer unknowns.</source>
        <translation>Modelu nie da się dopasować do tych punktów; sprawdź, czy współrzędne nie są zamienione, a wysokości błędne, włącz wyszukiwanie błędów grubych (ROBUST) albo wybierz model o mniejszej liczbie niewiadomych.</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/measure/messages.py" line="93"/>
        <source>The model can&apos;t be inverted over the image, so it is unsound away from its points; check their places, heights and reference system, choose a lower order, or add points.</source>
        <translation>Modelu nie można odwrócić na całym obrazie, więc poza swoimi punktami jest niewiarygodny; sprawdź ich położenia, wysokości i układ współrzędnych, wybierz niższy stopień albo dodaj punkty.</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/measure/messages.py" line="121"/>
        <source>{name} holds no camera that can be read; choose a file of orthority, OpenSfM, Metashape, Pix4D, Inpho or ContextCapture that does.</source>
        <translation>{name} nie zawiera kamery, którą można odczytać; wybierz plik programu orthority, OpenSfM, Metashape, Pix4D, Inpho lub ContextCapture, który ją zawiera.</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/measure/messages.py" line="149"/>
        <source>{name} holds no exterior orientation that can be read; choose a table with the columns filename, x, y, z, omega, phi, kappa, or a file of OpenSfM, Metashape, Pix4D, Inpho, PATB, ContextCapture or orthority.</source>
        <translation>{name} nie zawiera orientacji zewnętrznej, którą można odczytać; wybierz tabelę z kolumnami filename, x, y, z, omega, phi, kappa albo plik programu OpenSfM, Metashape, Pix4D, Inpho, PATB, ContextCapture lub orthority.</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/measure/messages.py" line="156"/>
        <source>Choose the folder of an OpenDroneMap project, with opensfm/reconstruction.json in it (PHOTOS), or the file of the photos&apos; orientations (EXTERIOR).</source>
        <translation>Wskaż katalog projektu OpenDroneMap, w którym jest opensfm/reconstruction.json (PHOTOS), albo plik orientacji zdjęć (EXTERIOR).</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/measure/messages.py" line="163"/>
        <source>The exterior orientation {name} is in no projected coordinate reference system in metres, which the camera&apos;s perspective needs; set one, with x, y and z in it.</source>
        <translation>Orientacja zewnętrzna {name} nie jest w płaskim układzie współrzędnych w metrach, a tylko w takim kamera ma swoją perspektywę; ustaw taki układ i podaj w nim x, y i z.</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/measure/messages.py" line="188"/>
        <source>Heights that refer to geoid need a grid file (GEOID), and no others do; give both or neither.</source>
        <translation>Wysokości odniesione do geoid wymagają pliku siatki (GEOID), a inne go nie potrzebują; podaj oba albo żadne z nich.</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/measure/messages.py" line="189"/>
        <source>Give either a terrain model or, where the terrain is flat, a constant height.</source>
        <translation>Podaj albo NMT, albo, gdy teren jest płaski, stałą wysokość.</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/measure/messages.py" line="191"/>
        <source>Heights from {low:.6g} to {high:.6g} m ({name}) are impossible on Earth; give metres, the lowest first, and set the nodata value of a terrain model.</source>
        <translation>Wysokości od {low:.6g} do {high:.6g} m ({name}) nie ma nigdzie na Ziemi; podaj metry, najpierw najniższą, a w NMT ustaw wartość braku danych (nodata).</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/measure/messages.py" line="203"/>
        <source>The terrain model {name} has a grid spacing of {mesh:.1f} m; 10 to 30 m work best: a coarser grid loses relief, and a finer one may bend straight lines such as roads in a satellite image.</source>
        <translation>NMT {name} ma oczka {mesh:.1f} m; najlepsze są od 10 do 30 m: w większych ginie rzeźba terenu, a mniejsze mogą na obrazie satelitarnym wyginać linie proste, na przykład drogi.</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/orthorectify.py" line="50"/>
        <source>Where the camera of an aerial photo was and how it looked: a table with filename, x, y, z, omega, phi and kappa, or a file of OpenSfM (an OpenDroneMap project&apos;s folder, too), Metashape, Pix4D, Applanix, Inpho, PATB, ContextCapture or orthority.</source>
        <translation>Gdzie była i jak patrzyła kamera zdjęcia lotniczego: tabela z kolumnami filename, x, y, z, omega, phi i kappa albo plik programu OpenSfM (także katalog projektu OpenDroneMap), Metashape, Pix4D, Applanix, Inpho, PATB, ContextCapture lub orthority.</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/orthorectify.py" line="55"/>
        <source>The camera of an aerial photo, as orthority, OpenSfM, Metashape, Pix4D, Inpho or ContextCapture write it. Empty: in the file of the exterior orientation.</source>
        <translation>Kamera zdjęcia lotniczego w zapisie programu orthority, OpenSfM, Metashape, Pix4D, Inpho lub ContextCapture. Puste: w pliku orientacji zewnętrznej.</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/orthorectify.py" line="136"/>
        <source>_RPC.TXT, .RPB, RPC_*.XML (DIMAP) or .geom. Without it and without a model file: the image&apos;s own RPC.</source>
        <translation>_RPC.TXT, .RPB, RPC_*.XML (DIMAP) lub .geom. Bez niego i bez pliku modelu: własne RPC obrazu.</translation>
    </message>
    <message>
        <location filename="../plugin/sensors/sensor_parameters.py" line="45"/>
        <source>A point layer with the fields column and row (the place in the image in pixels, 0 0 being the upper left corner of the first pixel), and if there are any id, z, role (control or check) and sigma (standard deviation in pixels); or a .points file of QGIS&apos;s georeferencer, or a TIFF that holds such points. Empty: those inside the image.</source>
        <translation>Warstwa punktowa z polami column i row (miejsce na obrazie w pikselach, gdzie 0 0 to lewy górny róg pierwszego piksela) oraz, jeśli są, id, z, role (control lub check) i sigma (odchylenie standardowe w pikselach); albo plik .points z georeferencera QGIS lub TIFF, który zawiera takie punkty. Puste pole: punkty zapisane w obrazie.</translation>
    </message>
    <message>
        <source>A seam is where the mosaic passes from one orthoimage to the next; where the two are blended, fine detail is lost.</source>
        <translation>Linia mozaikowania to miejsce, w którym ortofotomapa przechodzi z jednego ortoobrazu w drugi; gdzie oba są zmieszane, giną drobne detale.</translation>
    </message>
    <message>
        <source>The decision is on the seams only. Not checked: sharpness of the mosaic as a whole, damage in one colour alone, positional accuracy, the orthoimages themselves, clouds and shadows, ground hidden by buildings, metadata.</source>
        <translation>Decyzja dotyczy tylko linii mozaikowania. Nie sprawdzono: ostrości ortofotomapy jako całości, uszkodzeń w jednym tylko kolorze, dokładności położenia, samych ortoobrazów, chmur i cieni, terenu zasłoniętego przez budynki, metadanych.</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/measure/messages.py" line="43"/>
        <source>{size} of {lot} pieces are drawn.</source>
        <translation>Wylosowano odcinki: {size} z {lot}.</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/measure/messages.py" line="81"/>
        <source>{share:.0%} of the mosaic of &apos;{name}&apos; match no orthoimage, {limit:.0%} is allowed; most around {place}</source>
        <translation>{share:.0%} ortofotomapy „{name}” nie odpowiada żadnemu ortoobrazowi, a dopuszcza się {limit:.0%}; najwięcej w pobliżu {place}</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/measure/messages.py" line="124"/>
        <source>{standard}, lot of {lot}, level {level}, AQL {aql:g}, code letter {letter}</source>
        <translation>{standard}, liczność partii {lot}, poziom {level}, AQL {aql:g}, znak literowy {letter}</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/measure/messages.py" line="125"/>
        <source>{standard}, isolated lot of {lot}, limiting quality {lq:g} %</source>
        <translation>{standard}, partia izolowana o liczności {lot}, jakość graniczna {lq:g} %</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/measure/messages.py" line="136"/>
        <source>What would decide it: a scan with pieces of {piece:.0f} m (PIECE), with which some {share:.0%} of the metres would be measured.</source>
        <translation>Co by rozstrzygnęło: skanowanie z odcinkami po {piece:.0f} m (PIECE), przy których udałoby się zmierzyć około {share:.0%} metrów.</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/measure/messages.py" line="195"/>
        <source>The layers of seams were measured with different settings: {setting} is {values}.</source>
        <translation>Warstw linii mozaikowania nie zmierzono jednakowo: {setting} to {values}.</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/measure/messages.py" line="206"/>
        <source>Windows that operators inspected: {count}; with a cause: {causes}; judged visible: {visible}, invisible: {invisible}. They explain failures and do not change the decision.</source>
        <translation>Okna skontrolowane przez operatorów: {count}; z przyczyną: {causes}; uznane za widoczne: {visible}, za niewidoczne: {invisible}. Wyjaśniają usterki i nie zmieniają decyzji.</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/measure/messages.py" line="242"/>
        <source>The scan of &apos;{name}&apos; found the seams from the pixels, without seamlines, and wide feathers hide some of them.</source>
        <translation>Skanowanie „{name}” znalazło linie mozaikowania z pikseli, bez linii od wykonawcy, a szerokie wtapianie część z nich ukrywa.</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/paper/acceptance_report.py" line="155"/>
        <source>what is kept is known too roughly</source>
        <translation>zachowanie znane zbyt zgrubnie</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/paper/acceptance_report.py" line="169"/>
        <source>orthoimages along the seams</source>
        <translation>ortoobrazy wzdłuż linii mozaikowania</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/paper/acceptance_report.py" line="134"/>
        <source>; sheets rejected by themselves: {count}</source>
        <translation>; arkusze odrzucone same w sobie: {count}</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/paper/words.py" line="129"/>
        <source>open</source>
        <translation>nierozstrzygnięte</translation>
    </message>
    <message>
        <source>A failure is counted along one seam, and further where exactly two failed pieces meet.</source>
        <translation>Usterkę liczy się wzdłuż jednej linii mozaikowania i dalej tam, gdzie spotykają się dokładnie dwa niezgodne odcinki.</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/acceptmosaic.py" line="71"/>
        <source>Inspected windows: each gives its cause and remarks to the failures of which it shows a part.</source>
        <translation>Skontrolowane okna: każde przekazuje przyczynę i uwagi usterkom, których część pokazuje.</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/paper/paper_head.py" line="69"/>
        <source>The decision on paper, to be signed: rules, sheets, a map, the failures with pictures of the longest {most}. Opens in a browser and prints on A4.</source>
        <translation>Decyzja na papierze, do podpisu: reguły, arkusze, mapa, usterki z obrazami najdłuższych (najwyżej {most}). Otwiera się w przeglądarce i drukuje na A4.</translation>
    </message>
    <message>
        <source>The decision on paper, to be signed: rules, sheets, a map, the failures with pictures of the longest 100. Opens in a browser and prints on A4.</source>
        <translation>Decyzja na papierze, do podpisu: reguły, arkusze, mapa, usterki ze zdjęciami 100 najdłuższych. Otwiera się w przeglądarce i drukuje na A4.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/judge_bar.py" line="168"/>
        <source>By the scan, this piece of seam: {finding}</source>
        <translation>Według badania ten odcinek linii mozaikowania: {finding}</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/map/window_tool.py" line="215"/>
        <source>{width} x {height} m, {columns} x {rows} px, no source lies there</source>
        <translation>{width} × {height} m, {columns} × {rows} px, nie leży tam żaden ortoobraz</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/windows/window_columns.py" line="141"/>
        <source>How sure the observer is.</source>
        <translation>Jak pewny jest obserwator.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/report/flagged_windows.py" line="172"/>
        <source>Main cause: {cause}.</source>
        <translation>Główna przyczyna: {cause}.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/window_summary.py" line="149"/>
        <source>This follows from the mixture of the images; the ground around can&apos;t tell it.</source>
        <translation>Mówi to mieszanina obrazów; teren wokół tego nie powie.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/algorithms/mendseams.py" line="65"/>
        <source>A folder for the patches, cloud-optimised GeoTIFFs with an alpha band.</source>
        <translation>Katalog na łaty, czyli pliki COG z kanałem alfa.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/measure/messages.py" line="45"/>
        <source>Seams without a window, as they lie within windows of longer ones or outside the mosaic, or are shorter than {shortest:.2f} m: {count}.</source>
        <translation>Linie mozaikowania bez okna, bo leżą w oknach dłuższych linii lub poza ortofotomapą albo są krótsze niż {shortest:.2f} m: {count}.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/measure/messages.py" line="273"/>
        <source>The scan starts from the beginning, as one of its files, a setting or the plugin&apos;s version changed since it stopped.</source>
        <translation>Badanie zaczyna się od nowa, bo od jego przerwania zmienił się któryś z plików, ustawienia lub wersja wtyczki.</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/paper/quality_document.py" line="97"/>
        <source>Each piece of seam on ground with detail.</source>
        <translation>Każdy odcinek linii mozaikowania na terenie ze szczegółami.</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/measure/messages.py" line="130"/>
        <source>{metres:.1f} of {all:.1f} m of seam could not be measured.</source>
        <translation>Nie udało się zmierzyć {metres:.1f} z {all:.1f} m linii mozaikowania.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/messages.py" line="17"/>
        <source>No window there: pixels are missing. Draw a smaller one beside the edge.</source>
        <translation>Brak okna: brakuje tam pikseli. Narysuj mniejsze obok krawędzi.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/messages.py" line="26"/>
        <source>The layer {name} has windows of {older}, and the mosaic is {newer} now.</source>
        <translation>Warstwa {name} zawiera okna ortofotomapy {older}, a wybrana jest teraz ortofotomapa {newer}.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/messages.py" line="27"/>
        <source>The scan was stopped: its mosaic is not in the project any more.</source>
        <translation>Zatrzymano badanie: badanej ortofotomapy nie ma już w projekcie.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/session.py" line="305"/>
        <source>Windows of {mosaic}</source>
        <translation>Okna: {mosaic}</translation>
    </message>
    <message>
        <location filename="../plugin/seams/measure/messages.py" line="8"/>
        <source>{name} can&apos;t be &apos;{value}&apos;; choose one of {known}.</source>
        <translation>{name} nie może mieć wartości „{value}”; wybierz jedną z: {known}.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/measure/messages.py" line="101"/>
        <source>What is kept along the seam lies somewhere between {low:.0f} and {high:.0f} %; measure more of the seam.</source>
        <translation>O tym, co zachowano wzdłuż linii mozaikowania, można powiedzieć tylko, że leży między {low:.0f} a {high:.0f} %; zmierz dłuższy odcinek linii.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/measure/messages.py" line="271"/>
        <source>The work continues where it stopped; parts that are done already: {done}.</source>
        <translation>Praca jest kontynuowana od miejsca, w którym ją przerwano; gotowe już części: {done}.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/measure/messages.py" line="288"/>
        <source>The work was stopped; started again with the same output it continues from here.</source>
        <translation>Pracę przerwano; ponowiona z tym samym plikiem wyniku ruszy dalej.</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/measure/messages.py" line="66"/>
        <source>{value:.2%} of the measured metres failed, {limit:.2%} is allowed; with what is unknown, such as {metres:.0f} m that were not measured, it may be up to {high:.2%}</source>
        <translation>niezgodnych jest {value:.2%} zmierzonych metrów, a dopuszcza się {limit:.2%}, lecz wraz z tym, czego nie wiadomo, na przykład z {metres:.0f} m, których nie zmierzono, może to być do {high:.2%}</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/measure/messages.py" line="103"/>
        <source>along {metres:.0f} m of seam the mosaic is mixed into the orthoimages ({names}), which hides what it lost there</source>
        <translation>wzdłuż {metres:.0f} m linii mozaikowania ortofotomapa jest domieszana do ortoobrazów ({names}), co ukrywa to, co tam straciła</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/measure/messages.py" line="234"/>
        <source>{count} mosaics were scanned one by one: seams on their borders do not count, where they overlap twice.</source>
        <translation>Ortofotomapy skanowano osobno (liczba: {count}): linie mozaikowania wzdłuż ich granic się nie liczą, a tam, gdzie się pokrywają, liczą się dwa razy.</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/paper/acceptance_report.py" line="172"/>
        <source>the mosaic is mixed into them along {metres} of seam, such as at {place}</source>
        <translation>ortofotomapa jest do nich domieszana wzdłuż {metres} linii mozaikowania, na przykład w miejscu {place}</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/paper/acceptance_report.py" line="181"/>
        <source>not given: {names}</source>
        <translation>nie podano: {names}</translation>
    </message>
    <message>
        <location filename="../plugin/imagery/messages.py" line="70"/>
        <source>&apos;{wavelet}&apos; is not orthogonal, or no wavelet of PyWavelets; use one such as coif3, db4 or sym8.</source>
        <translation>&apos;{wavelet}&apos; nie jest ortogonalna albo nie jest falką z PyWavelets; użyj takiej jak coif3, db4 lub sym8.</translation>
    </message>
    <message>
        <location filename="../plugin/resolution/measure/messages.py" line="13"/>
        <source>Not one straight line; draw it with two points across the bars of the group.</source>
        <translation>To nie jest jedna linia prosta; narysuj ją dwoma punktami w poprzek pasków grupy.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/map/window_tool.py" line="217"/>
        <source>{width} x {height} m, {columns} x {rows} px, nothing can be compared there</source>
        <translation>{width} × {height} m, {columns} × {rows} px, nie da się tam nic porównać</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/messages.py" line="18"/>
        <source>Windows at the worst places: {count}, {sides} m wide; there already: {there}.</source>
        <translation>Okna w najgorszych miejscach: {count}, szerokości {sides} m; już istniejące: {there}.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/measure/messages.py" line="226"/>
        <source>No seamline separates two orthoimages on the mosaic: all run along the border of its pixels or within one orthoimage. Check the reference systems, the field that names the orthoimages, and that these are not cut from the mosaic.</source>
        <translation>Żadna linia mozaikowania nie rozdziela na ortofotomapie dwóch ortoobrazów: wszystkie biegną wzdłuż granicy jej pikseli albo wewnątrz jednego ortoobrazu. Sprawdź układy współrzędnych, pole, które nazywa ortoobrazy, i czy nie wycięto ich z ortofotomapy.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/measure/messages.py" line="376"/>
        <source>All {count} orthoimages show the mosaic&apos;s pixels on both sides of its seams: they are copies of it, or parts of the only image that it was made of, and can&apos;t show what it lost. Give the orthoimages as they were rectified, before the mosaic was made, or none, to scan along seamlines alone.</source>
        <translation>Wszystkie ortoobrazy ({count}) mają po obu stronach linii mozaikowania piksele ortofotomapy: są jej kopiami albo częściami jedynego obrazu, z którego ją wykonano, i nie pokażą, co straciła. Podaj ortoobrazy po ortorektyfikacji, sprzed wykonania ortofotomapy, albo żadnych, aby skanować wzdłuż samych linii mozaikowania.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/measure/messages.py" line="393"/>
        <source>Along {metres:.0f} m of seam, such as at {x:.1f}, {y:.1f}, up to {share:.0f} % of the mosaic are mixed into the orthoimages ({names}), which hides what it lost there. Ask for the orthoimages as they were before the mosaic was made.</source>
        <translation>Wzdłuż {metres:.0f} m linii mozaikowania, na przykład w miejscu {x:.1f}; {y:.1f}, do {share:.0f} % ortofotomapy domieszano do ortoobrazów ({names}), co ukrywa to, co tam straciła. Poproś o ortoobrazy sprzed wykonania ortofotomapy.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/report/flagged_windows.py" line="58"/>
        <source>by the paper&apos;s rule: {verdict}, ratio 1: {ratio}</source>
        <translation>według reguły z artykułu: {verdict}, stosunek 1: {ratio}</translation>
    </message>
    <message>
        <location filename="../plugin/seams/window_summary.py" line="340"/>
        <source>Its curve lies apart all the same: curves are shares of all contrast, which tones change, too.</source>
        <translation>Mimo to jego krzywa leży osobno: krzywe są udziałami w całym kontraście, który zmieniają też tony.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/window_summary.py" line="48"/>
        <source>composite: {value}</source>
        <translation>kompozycja: {value}</translation>
    </message>
    <message>
        <location filename="../plugin/seams/window_summary.py" line="46"/>
        <source>sharpness 1: {value}</source>
        <translation>ostrość 1: {value}</translation>
    </message>
    <message>
        <location filename="../plugin/seams/window_summary.py" line="66"/>
        <source>kept 1: {value}</source>
        <translation>zachowane 1: {value}</translation>
    </message>
    <message>
        <location filename="../plugin/seams/window_summary.py" line="68"/>
        <source>kept 1: {value} ({low} to {high})</source>
        <translation>zachowane 1: {value} (od {low} do {high})</translation>
    </message>
    <message>
        <location filename="../plugin/seams/window_summary.py" line="49"/>
        <source>ratio 1: {value}</source>
        <translation>stosunek 1: {value}</translation>
    </message>
    <message>
        <location filename="../plugin/seams/window_summary.py" line="151"/>
        <source>Other detail was added along the seam.</source>
        <translation>Wzdłuż linii dodano inne szczegóły.</translation>
    </message>
    <message>
        <location filename="../plugin/toolkit/messages.py" line="17"/>
        <source>The window is not a single polygon whose outline crosses nowhere; draw it as a rectangle.</source>
        <translation>Okno nie jest pojedynczym poligonem, którego obrys nigdzie się nie przecina; narysuj je jako prostokąt.</translation>
    </message>
    <message>
        <location filename="../plugin/toolkit/messages.py" line="48"/>
        <source>The Dask scheduler at {address} is gone, or has no workers that answer; start some, or give no scheduler.</source>
        <translation>Scheduler Dask pod adresem {address} przestał działać albo nie ma procesów roboczych, które odpowiadają; uruchom je albo nie podawaj schedulera.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/judge_bar.py" line="170"/>
        <source>No window at the worst places is left to judge.</source>
        <translation>W najgorszych miejscach nie ma już okien do oceny.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/judge_bar.py" line="172"/>
        <source>No window is left to judge.</source>
        <translation>Nie ma już okien do oceny.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/judging.py" line="63"/>
        <source>Worst places: {left} of {count} to go</source>
        <translation>Najgorsze: zostało {left} z {count}</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/judging.py" line="64"/>
        <source>{unsure} not sure</source>
        <translation>niepewne: {unsure}</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/map/lost_detail.py" line="297"/>
        <source>Detail kept: reading ...</source>
        <translation>Zachowany detal: wczytywanie...</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/windows/window_columns.py" line="114"/>
        <source>The finest detail that is missing, along the seam or in the whole window, given as the square metres of the window that hold as much; empty where no loss is certain.</source>
        <translation>Brakujący najdrobniejszy detal, wzdłuż linii mozaikowania lub w całym oknie, wyrażony liczbą metrów kwadratowych okna, które tyle go zawierają; puste tam, gdzie strata nie jest pewna.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/tables/scan_layers.py" line="79"/>
        <source>None of {metres:.0f} m of seams failed.</source>
        <translation>Niezgodne: 0 z {metres:.0f} m linii.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/tables/scan_layers.py" line="81"/>
        <source>None of {metres:.0f} m of seams could be measured.</source>
        <translation>Nie dało się zmierzyć żadnego z {metres:.0f} m linii.</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/measure/messages.py" line="143"/>
        <source>What would decide it: an operator&apos;s look at what was not measured, at least {wanted:.0f} of {lacking:.0f} m; whoever signs decides by that. A scan with longer pieces may not measure enough.</source>
        <translation>Co by rozstrzygnęło: obejrzenie przez operatora tego, czego nie zmierzono, co najmniej {wanted:.0f} z {lacking:.0f} m; na tej podstawie rozstrzyga osoba podpisująca. Skanowanie z dłuższymi odcinkami może nie zmierzyć dość.</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/paper/acceptance_report.py" line="156"/>
        <source>an orthoimage ends there, or was not given</source>
        <translation>ortoobraz się tam kończy albo nie został podany</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/paper/acceptance_report.py" line="157"/>
        <source>the orthoimages do not explain the mosaic: changed, others, or too little texture</source>
        <translation>ortoobrazy nie wyjaśniają tam ortofotomapy: zmienione, inne albo za mało tekstury</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/paper/acceptance_report.py" line="158"/>
        <source>too short to be measured</source>
        <translation>za krótkie do pomiaru</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/paper/acceptance_report.py" line="159"/>
        <source>not enough to measure it without orthoimages, or these can&apos;t be read any more</source>
        <translation>za mało do pomiaru bez ortoobrazów albo nie można ich już odczytać</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/paper/acceptance_report.py" line="136"/>
        <source>; sheets undecided by themselves: {count}</source>
        <translation>; arkusze same w sobie nierozstrzygnięte: {count}</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/paper/acceptance_report.py" line="176"/>
        <source>missing, without pixels or not explaining the mosaic along {metres} of seam, such as at {place}; to be given by the producer</source>
        <translation>brakuje ich, nie mają pikseli albo nie wyjaśniają ortofotomapy wzdłuż {metres} linii mozaikowania, na przykład w miejscu {place}; ma je dostarczyć wykonawca</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/paper/acceptance_report.py" line="184"/>
        <source>none were given, or their files can&apos;t be read</source>
        <translation>nie podano ich albo nie można odczytać ich plików</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/paper/acceptance_report.py" line="229"/>
        <source>; with those that meet {joined}</source>
        <translation>; z tymi, które się stykają, {joined}</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/paper/quality_document.py" line="96"/>
        <source>Length of seam along which orthoimages are missing, without pixels or do not explain the mosaic.</source>
        <translation>Długość linii mozaikowania, wzdłuż których brakuje ortoobrazów, nie mają one pikseli albo nie wyjaśniają ortofotomapy.</translation>
    </message>
    <message>
        <source>the layer of failures with its folder of pictures</source>
        <translation>warstwa usterek z jej katalogiem obrazków</translation>
    </message>
    <message>
        <source>the findings in bold</source>
        <translation>uwagi zapisane pogrubieniem</translation>
    </message>
    <message>
        <source>To be sent to the producer: {what}.</source>
        <translation>Do przesłania wykonawcy: {what}.</translation>
    </message>
    <message>
        <source>Between two failed pieces of a failure may lie one that was not measured, no longer than a typical piece. Kept, the orthoimages and the band refer to the piece that kept least.</source>
        <translation>Między dwoma niezgodnymi odcinkami usterki może leżeć jeden niezmierzony, nie dłuższy od typowego. Zachowanie, ortoobrazy i szerokość pasa dotyczą odcinka, który zachował najmniej.</translation>
    </message>
    <message>
        <source>an orthoimage is not shown, since it ends here or was not given</source>
        <translation>nie pokazano jednego z ortoobrazów, bo się tu kończy albo nie został podany</translation>
    </message>
    <message>
        <source>no cut is shown, since pixels of the mosaic are missing around the place, or the mosaic does not follow these orthoimages</source>
        <translation>nie pokazano ortoobrazów ciętych ostro, bo wokół tego miejsca brakuje pikseli ortofotomapy albo nie odpowiada ona tym ortoobrazom</translation>
    </message>
    <message>
        <location filename="../plugin/seams/measure/messages.py" line="302"/>
        <source>There is too little texture along this piece to measure it; judge it by eye.</source>
        <translation>Wzdłuż tego odcinka jest za mało tekstury, by go zmierzyć; oceń go okiem.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/measure/messages.py" line="304"/>
        <source>Too little of the ground beside this piece can be compared: an orthoimage ends there, or none shows what the mosaic does; judge it by eye, or give the orthoimages that it was made from.</source>
        <translation>Za mało terenu przy tym odcinku można porównać: ortoobraz się tam kończy albo żaden nie pokazuje tego co ortofotomapa; oceń go okiem lub podaj ortoobrazy, z których powstała.</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/measure/messages.py" line="112"/>
        <source>along {metres:.0f} of {judged:.0f} m of seam that are judged both sides show the same orthoimage, {limit:.0%} is allowed</source>
        <translation>wzdłuż {metres:.0f} z {judged:.0f} m ocenianych linii mozaikowania po obu stronach widać ten sam ortoobraz, a dopuszcza się {limit:.0%}</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/measure/messages.py" line="115"/>
        <source>beside {judged:.0f} m of seam that are judged the scan saw the mosaic change from one orthoimage to another along {metres:.0f} m, the longest around {place}; {limit:.0%} is allowed</source>
        <translation>obok {judged:.0f} m ocenianych linii mozaikowania skan widział, że ortofotomapa przechodzi z jednego ortoobrazu w drugi wzdłuż {metres:.0f} m, najdłużej w pobliżu {place}, a brakować może {limit:.0%}</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/measure/messages.py" line="139"/>
        <source>What would decide it: a scan with the orthoimages that the mosaic was made from, complete and unchanged. Along {metres:.0f} m, such as at {place}, pixels are missing or were changed, or those that were given do not explain the mosaic; ask the producer for them.</source>
        <translation>Co by rozstrzygnęło: skanowanie z kompletnymi i niezmienionymi ortoobrazami, z których powstała ortofotomapa. Wzdłuż {metres:.0f} m, na przykład w {place}, brakuje pikseli lub je zmieniono, albo podane ortoobrazy nie wyjaśniają ortofotomapy; poproś o nie wykonawcę.</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/measure/messages.py" line="165"/>
        <source>What would decide it: a scan with seamlines that lie wherever the mosaic changes from one orthoimage to another, and nowhere else, or with none.</source>
        <translation>Co by rozstrzygnęło: skanowanie z liniami mozaikowania, które leżą wszędzie tam, gdzie ortofotomapa przechodzi z jednego ortoobrazu w drugi, i nigdzie indziej, albo bez linii.</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/paper/acceptance_report.py" line="200"/>
        <source>given: {judged}</source>
        <translation>podane: {judged}</translation>
    </message>
    <message>
        <source>Visible loss: just noticeable differences (JND) of contrast at 2x on a screen, by a model of an eye. A piece fails by the detail that it lost, whatever an eye sees of that.</source>
        <translation>Widoczna strata: wielokrotność ledwie zauważalnej różnicy (JND) kontrastu w powiększeniu 2x na ekranie, według modelu oka. O niezgodności odcinka decydują utracone detale, niezależnie od tego, co widzi oko.</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/measure/messages.py" line="121"/>
        <source>along {metres:.0f} m between two orthoimages, the longest around {place}, no seam is judged, or neither explains the mosaic; with these {value:.2%} of the metres may have failed, {limit:.2%} is allowed</source>
        <translation>na {metres:.0f} m między dwoma ortoobrazami, najdłużej przy {place}, nie oceniono żadnej linii albo żaden nie wyjaśnia ortofotomapy; z nimi mogło zawieść {value:.2%} metrów, a wolno {limit:.2%}</translation>
    </message>
    <message>
        <location filename="../plugin/seams/measure/messages.py" line="330"/>
        <source>The mosaic passes from one orthoimage to another along some {metres:.0f} m where no seam is measured, the longest {longest:.0f} m around {x:.1f}, {y:.1f}: no seamline is given there, it is too short to be found, or the place was blurred or cut out. Check it, and give the seamlines that are missing.</source>
        <translation>Ortofotomapa przechodzi z jednego ortoobrazu w drugi na około {metres:.0f} m, gdzie nie zmierzono linii mozaikowania, najdłużej {longest:.0f} m przy {x:.1f}; {y:.1f}: nie podano tam linii mozaikowania, jest za krótka, by ją znaleźć, albo miejsce rozmyto lub wycięto. Obejrzyj je i podaj brakujące linie mozaikowania.</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/paper/acceptance_report.py" line="127"/>
        <source>failed: {failed} of {length} that were measured</source>
        <translation>niezgodne: {failed} z {length} zmierzonych</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/paper/acceptance_report.py" line="129"/>
        <source>, of which {near} surely lost detail, and more than allowed by the best estimate</source>
        <translation>, z czego {near} na pewno straciło detale, a według najlepszego oszacowania więcej niż wolno</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/paper/acceptance_report.py" line="130"/>
        <source>; failures: {count}, in sheets: {sheets} of {all}</source>
        <translation>; usterki: {count}, w arkuszach: {sheets} z {all}</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/messages.py" line="10"/>
        <source>The windows of this mosaic can&apos;t be opened: {path}. Put the file back and open the project again, or remove the layer to begin anew.</source>
        <translation>Okien tej ortofotomapy nie można otworzyć: {path}. Przywróć plik i otwórz projekt ponownie albo usuń warstwę, aby zacząć od nowa.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/measure/messages.py" line="319"/>
        <source>{metres:.0f} m were not measured. {reason}</source>
        <translation>Nie zmierzono {metres:.0f} m. {reason}</translation>
    </message>
    <message>
        <location filename="../plugin/acceptance/paper/inspection_record.py" line="86"/>
        <source>typical length of the pieces</source>
        <translation>typowa długość odcinków</translation>
    </message>
    <message>
        <location filename="../plugin/seams/charts/profile_painter.py" line="128"/>
        <source>{kept} % kept ({low} to {high} %) in {width} m; around it {left} %</source>
        <translation>zachowano {kept} % ({low} do {high} %) na {width} m; wokół {left} %</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/mosaic_scans.py" line="261"/>
        <source>A piece fails that keeps {percent} % or less.</source>
        <translation>Niezgodny jest odcinek, na którym zachowano {percent} % lub mniej.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/tables/scan_layers.py" line="80"/>
        <source>{failed:.0f} of {metres:.0f} m failed.</source>
        <translation>Niezgodne {failed:.0f} z {metres:.0f} m.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/tables/scan_layers.py" line="82"/>
        <source>{finding} {lacking:.0f} m not measured.</source>
        <translation>{finding} Nie zmierzono {lacking:.0f} m.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/window_summary.py" line="290"/>
        <source>As much of the finest detail is left {strip} as around it</source>
        <translation>Najdrobniejszych detali zostało {strip} tyle co wokół niej</translation>
    </message>
    <message>
        <location filename="../plugin/seams/window_summary.py" line="239"/>
        <source>{lost} % of detail lost {strip}</source>
        <translation>{lost} % detali utracono {strip}</translation>
    </message>
    <message>
        <location filename="../plugin/seams/window_summary.py" line="292"/>
        <source>No loss is certain {strip}</source>
        <translation>Żadna strata {strip} nie jest pewna</translation>
    </message>
    <message>
        <location filename="../plugin/seams/window_summary.py" line="174"/>
        <source>beside the seam</source>
        <translation>przy linii</translation>
    </message>
    <message>
        <location filename="../plugin/seams/window_summary.py" line="174"/>
        <source>in {width} m along the seam</source>
        <translation>w pasie {width} m wzdłuż linii</translation>
    </message>
    <message>
        <location filename="../plugin/seams/words.py" line="150"/>
        <source>softened seam</source>
        <translation>zmiękczona linia</translation>
    </message>
    <message>
        <location filename="../plugin/seams/words.py" line="151"/>
        <source>The mosaic was softened along the seam: less is left than a mixture of its images would leave.</source>
        <translation>Ortofotomapa została zmiękczona wzdłuż linii mozaikowania: zostało mniej, niż zostawiłoby zmieszanie obrazów.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/words.py" line="152"/>
        <source>the seam is softened</source>
        <translation>linia mozaikowania jest zmiękczona</translation>
    </message>
    <message>
        <location filename="../plugin/seams/words.py" line="153"/>
        <source>softened</source>
        <translation>zmiękczenie</translation>
    </message>
    <message>
        <location filename="../plugin/seams/words.py" line="154"/>
        <source>Don&apos;t soften it.</source>
        <translation>Nie zmiękczaj jej.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/charts/curves_tab.py" line="104"/>
        <source>Window {number}; {count} more {count:source covers|sources cover} a part</source>
        <translation>Okno {number}; jeszcze {count} {count:źródło|źródła|źródeł} w części okna</translation>
    </message>
    <message>
        <location filename="../plugin/seams/desk/charts/curves_tab.py" line="189"/>
        <source>No seam runs through this window.</source>
        <translation>Przez to okno nie przebiega żadna linia mozaikowania.</translation>
    </message>
    <message>
        <location filename="../plugin/seams/measure/messages.py" line="48"/>
        <source>Windows placed along the seams: {count}; places taken before: {there}.</source>
        <translation>Okna wzdłuż linii mozaikowania: {count}; miejsca już zajęte: {there}.</translation>
    </message>
</context>
</TS>
