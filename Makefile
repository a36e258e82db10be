# `make` says what there is. A study is a folder studies/NAME with study.info and quick.info;
# its figures are plots/NAME_*.gp. Both are found here by their files.
SHELL := bash
.SHELLFLAGS := -eu -o pipefail -c
.DELETE_ON_ERROR:
MAKEFLAGS += --no-builtin-rules

JOBS ?= $(shell nproc)
BUILD := build/release
FUZZ_SECONDS ?= 60
PREFIX ?= /usr/local
SAMPLE ?= carter wiggle_spectrum basis_convergence smoothing
VERSION = $(shell sed -n 's/^project.microslip VERSION \([0-9.]*\).*/\1/p' CMakeLists.txt)
READERS := $(patsubst fuzz/targets/%.cpp,%,$(wildcard fuzz/targets/*.cpp))
STUDIES := $(patsubst studies/%/study.info,%,$(wildcard studies/*/study.info))
SOURCES = $(shell find core scene thesis capi python experiments program apps studies bench examples tests tools fuzz \
  -name '*.[ch]pp' -o -name '*.[ch]')

.PHONY: help deps build install package wheels docs figures report article claim claims archive verify-archive quick bench test thorough verify references accuracy coverage mutants sanitize fuzz keep-corpus \
  format check-format clean $(STUDIES)

help:
	@echo 'make figures      build, run every study, draw every figure into results/figures'
	@echo 'make report       the same, and results/report.html: every claim with its verdict, figure and parameters'
	@echo 'make article      every study, and results/article.pdf: a paper of which every number is read from the tables'
	@echo 'make claim        NAME=carter-2, or a part of its statement: runs its study; verdict, rule, time and memory'
	@echo 'make claims       a table of all claims with verdict and cost'
	@echo 'make archive      results/microslip-archive-VERSION.tar: tables, figures, article, sums and descriptions'
	@echo 'make verify-archive  its sums, and the studies SAMPLE="$(SAMPLE)" run again'
	@echo 'make STUDY        one study with its figures: $(STUDIES)'
	@echo 'make quick        every study, coarser, into results/quick'
	@echo 'make bench        times against N into results/bench, with figures; about five minutes'
	@echo 'make test         build everything, and run the tests'
	@echo 'make thorough     the tests that it leaves out: 50 digits, all generated cases, long runs, verdicts of the longest studies, Octave, pip, browser, LaTeX, packages'
	@echo 'make verify       make thorough; two clean builds: the same bytes; these, and other instructions and compilers: agreement with tests/reference_tables'
	@echo 'make references   make the tables of this build those of tests/reference_tables'
	@echo 'make accuracy     the orders that the tests measure, into docs/accuracy.md'
	@echo 'make coverage     the lines of core and scene that the tests run; at least 95 %'
	@echo 'make mutants      which test fails for each change of tests/mutants.tsv; MUTANTS="NAME ..." for some'
	@echo 'make sanitize     tests of units, of C and of the corpus under the address and undefined-behaviour sanitizers, and those of threads under the thread sanitizer'
	@echo 'make fuzz         libFuzzer on every reader of input, FUZZ_SECONDS=$(FUZZ_SECONDS) each, with both sanitizers'
	@echo 'make keep-corpus  what it found that reaches new code, into fuzz/corpus'
	@echo 'make build        only build the programs, into $(BUILD)/bin'
	@echo 'make docs         API pages, and what is solved, into build/docs/html'
	@echo 'make install      into PREFIX=$(PREFIX)'
	@echo 'make package      a Debian package into $(BUILD)/package'
	@echo 'make wheels       a wheel of the Python package into build/wheels, with the libraries inside that it needs'
	@echo 'make format       clang-format all sources; make check-format only looks'
	@echo 'make clean        remove the build, and the results that make has made; others in results stay'
	@echo 'Missing Debian packages are installed first (DEPS=skip: not). JOBS=$(JOBS) compilers at once.'

deps:
	@tools/deps.sh build figures

# $(call cmake_build,PRESET,OPTIONS): says what it compiles, and nothing if there is nothing to do.
cmake_build = mkdir -p build/$(1); \
  [ -f build/$(1)/CMakeCache.txt ] || cmake --preset $(1) $(CMAKE_FLAGS) >build/$(1)/configure.log || \
    { cat build/$(1)/configure.log; rm -f build/$(1)/CMakeCache.txt; exit 1; }; \
  cmake --build --preset $(1) -j $(JOBS) $(2) | \
    sed -u -e '/^ninja: no work to do/d' -e '/Re-checking globbed/d' -e '/revision.cmake$$/d' -e '/^-- /d'

build: deps
	@$(call cmake_build,release,--target programs)

install: build
	@cmake --install $(BUILD) --prefix "$(PREFIX)" >$(BUILD)/install.log || { cat $(BUILD)/install.log; exit 1; }
	@echo 'installed into $(PREFIX)'

package: build
	@tools/deps.sh package
	@cd $(BUILD) && cpack >cpack.log 2>&1 || { cat cpack.log; exit 1; }
	@ls $(BUILD)/package/*.deb

wheels: deps
	@tools/deps.sh wheels
	@$(call cmake_build,release,--target microslip_python)
	@tools/wheel.sh $(BUILD) build/wheels

docs:
	@tools/deps.sh docs
	@tools/docs.sh

# A study reruns when the content of its program changes, which includes its scenes; a new time stamp
# alone does nothing.
$(STUDIES:%=$(BUILD)/content/%): $(BUILD)/content/%: build
	@mkdir -p $(@D)
	@cmp -s $(BUILD)/bin/$* $@ || cp $(BUILD)/bin/$* $@

# $(call study_rules,STUDY,FOLDER,OPTIONS): the tables, and every figure from them. A study puts its
# provenance.txt in place last and whole: an interrupted make, which removes targets that have just
# changed, keeps it, so that its tables do not stay behind without it.
define study_rules
.PRECIOUS: $(2)/$(1)/provenance.txt
$(2)/$(1)/provenance.txt: $(BUILD)/content/$(1)
	$(BUILD)/bin/$(1)$(3) --out $(2)/$(1)

$(2)/figures/$(1)_%.svg: plots/$(1)_%.gp $(wildcard plots/$(1).gpi) plots/style.gp plots/draw.sh $(2)/$(1)/provenance.txt
	plots/draw.sh $$< $(2)/$(1) $$@
endef
figures_of = $(patsubst plots/%.gp,$(2)/figures/%.svg,$(wildcard plots/$(1)_*.gp))

$(foreach study,$(STUDIES),$(eval $(call study_rules,$(study),results,)))
$(foreach study,$(STUDIES),$(eval $(call study_rules,$(study),results/quick, --quick)))
$(foreach study,$(STUDIES),$(eval $(study): results/$(study)/provenance.txt $(call figures_of,$(study),results)))

results/report.html: README.md $(wildcard tools/report/*.*) $(foreach study,$(STUDIES),results/$(study)/provenance.txt $(call figures_of,$(study),results))
	tools/report/report.py results $@

results/article.pdf: $(wildcard article/*) $(wildcard tools/article/*) plots/style.gp plots/draw.sh $(foreach study,$(STUDIES),results/$(study)/provenance.txt)
	tools/article/article.sh results $@ build/article

# Studies side by side; what each prints comes out in one piece.
side_by_side = @$(MAKE) --no-print-directory --output-sync=target -j$(JOBS) DEPS=skip
figures: build
	$(side_by_side) $(STUDIES)
report: build
	@tools/deps.sh report
	$(side_by_side) results/report.html
article: build
	@tools/deps.sh report article
	$(side_by_side) results/article.pdf
claims: build
	@tools/deps.sh report
	$(side_by_side) $(foreach study,$(STUDIES),results/$(study)/provenance.txt)
	@tools/claims.py all results
archive: build
	@tools/deps.sh report article
	$(side_by_side) results/report.html results/article.pdf
	@tools/archive/archive.py results results
quick: build
	$(side_by_side) $(foreach study,$(STUDIES),$(call figures_of,$(study),results/quick))

# In a folder of its own, so that results stay as they are.
claim: build
	@tools/deps.sh report
	@tools/claims.py one $(BUILD)/bin build/claims "$${NAME-}"

verify-archive: deps
	@tools/deps.sh report
	@$(call cmake_build,release,--target programs compare_tables)
	@tools/archive/verify.py results/microslip-archive-$(VERSION).tar $(BUILD)/bin build/verify-archive $(SAMPLE)

# Timings differ from run to run: they are no part of the figures, and are measured whenever asked for.
# A build folder from before Google Benchmark was installed is configured anew.
bench:
	@tools/deps.sh build figures bench
	@grep -qs '^benchmark_DIR:PATH=/' $(BUILD)/CMakeCache.txt || rm -f $(BUILD)/CMakeCache.txt
	@$(call cmake_build,release,--target bench)
	$(BUILD)/bin/bench --out results/bench
	for figure in $(call figures_of,bench,results); do \
	  plots/draw.sh plots/$$(basename $$figure .svg).gp results/bench $$figure; \
	done

test: deps
	@tools/deps.sh report
	@$(call cmake_build,release)
	ctest --preset release -j $(JOBS)

# The tests that `make test` leaves out. Those of properties take all samples here, and a sixth of them there.
thorough: deps
	@tools/deps.sh report languages notebook docs browser package article
	@$(call cmake_build,release,--target all digits_tests)
	ctest --preset thorough -j $(JOBS)

verify: thorough
	@tools/verify.sh build/verify $(JOBS)

references: deps
	@$(call cmake_build,release,--target programs compare_tables)
	rm -rf build/references
	tools/quick_tables.sh $(BUILD)/bin build/references $(JOBS)
	$(BUILD)/bin/compare_tables --update build/references tests/reference_tables

accuracy: deps
	@$(call cmake_build,release,--target order_tests)
	@tools/accuracy.py $(BUILD)/bin/order_tests

# Tests of studies assert other things and would run for minutes; those of faults kill programs that
# write their counts, and let them run out of disk.
coverage:
	@tools/deps.sh build figures coverage
	@$(call cmake_build,coverage,--target unit_tests order_tests reference_tests robustness_tests programs)
	find build/coverage -name '*.gcda' -delete
	ctest --preset coverage -j $(JOBS)
	gcovr --root . --filter core/ --filter scene/ --exclude-throw-branches --fail-under-line 95 build/coverage

# In a copy of the tree; no part of the tests, as each mutant takes ten to fifty seconds.
mutants: deps
	@tools/mutants.py build/mutants $(JOBS) $(MUTANTS)

# Without tests in long runs: others run the same code, and `make test` runs all.
# As many processes run the tests of units as there are jobs: to start one for each test takes as long
# as the tests themselves.
sanitize:
	@tools/deps.sh build clang
	@$(call cmake_build,debug,--target unit_tests capi_tests corpus)
	ctest --preset debug -L 'capi|corpus' -j $(JOBS)
	seq 0 $$(($(JOBS) - 1)) | GTEST_TOTAL_SHARDS=$(JOBS) xargs -P $(JOBS) -I {} env GTEST_SHARD_INDEX={} \
	  build/debug/bin/unit_tests --gtest_brief=1 --gtest_filter='-LongRuns*'
	@$(threads)

# The thread sanitizer takes a build of its own.
threads = $(call cmake_build,threads,--target capi_tests); \
  build/threads/bin/capi_tests --gtest_brief=1 --gtest_filter='CThreads.*:CEllipse.ManyRoll*:*DifferentThreads*'

# Input that ends a reader is written to build/fuzz/findings; new input stays in build/fuzz/corpus.
fuzz:
	@tools/deps.sh build clang
	@$(call cmake_build,fuzz,--target corpus)
	@mkdir -p build/fuzz/findings $(READERS:%=build/fuzz/corpus/%)
	@for reader in $(READERS); do \
	  echo "$$reader: $(FUZZ_SECONDS) s"; \
	  build/fuzz/bin/fuzz_$$reader -dict=fuzz/dictionary -max_total_time=$(FUZZ_SECONDS) -max_len=8000 \
	    -timeout=20 -artifact_prefix=build/fuzz/findings/$$reader- -print_final_stats=1 \
	    build/fuzz/corpus/$$reader fuzz/corpus/$$reader >build/fuzz/$$reader.log 2>&1 || \
	    { tail -n 40 build/fuzz/$$reader.log; exit 1; }; \
	  grep number_of_executed_units build/fuzz/$$reader.log; \
	done

keep-corpus:
	@for reader in $(READERS); do \
	  build/fuzz/bin/fuzz_$$reader -merge=1 -max_len=8000 fuzz/corpus/$$reader build/fuzz/corpus/$$reader; \
	done

format:
	@clang-format -i $(SOURCES)

check-format:
	@clang-format --dry-run --Werror $(SOURCES)

# Other folders in results are of those who made them.
clean:
	rm -rf build $(STUDIES:%=results/%) results/quick results/figures results/bench results/report.html \
	  results/article.pdf results/microslip-archive-*.tar results/microslip-measured-*.tar
