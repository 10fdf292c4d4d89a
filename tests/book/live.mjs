/// The live experiments in a real browser: every chapter that is built plays to and fro with the same bits, and each control does
/// what it says, which is read off the simulation's state.
import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { chapters, launch, newPage, pageOf } from "./support/live.mjs";

let browser;
before(async () => (browser = await launch()));
after(() => browser.close());

const still = { reducedMotion: "reduce" };
const patience = 120000; // ms: a machine without a graphics card that has other work, too

/// A page whose experiment runs, as `player` there; it does not play by itself.
async function running(chapter, options = {}, address = pageOf(chapter)) {
  const page = await newPage(browser, { ...still, ...options });
  page.setDefaultTimeout(patience);
  await page.goto(address);
  await page.evaluate(async () => {
    window.player = await window.PUSHBACK_LIVE_TEST.start();
    for (const fold of document.querySelectorAll(".pb-fold")) fold.open = true;
  });
  return page;
}

/// Of all lanes: where they are, to the last bit.
const bits = (page) => page.evaluate(() => player.engine.lanes.map(({ lane }) => player.engine.hash(lane)));
const now = (page) => page.evaluate(() => player.engine.now);
const settled = (page) => page.waitForFunction(() => !player.playing && player.engine.now === player.target);
const seek = async (page, step) => {
  await page.evaluate((to) => player.go(to), step);
  await settled(page);
};

for (const chapter of chapters()) {
  test(`${chapter}: every scene is drawn, and an instant has the same bits however it is reached`, async () => {
    const page = await running(chapter);
    const scenes = await page.evaluate(() => player.engine.description.scenes.length);
    for (let scene = 0; scene < scenes; ++scene) {
      const seen = await page.evaluate((which) => {
        player.chooseScene(which);
        const { engine } = player;
        const all = () => engine.lanes.map(({ lane }) => engine.hash(lane)).join();
        const last = Math.min(engine.steps, 60),
          reached = {};
        const began = performance.now();
        for (let step = 1; step <= last && performance.now() - began < 4000; ++step) {
          engine.goTo(step);
          reached[step] = all();
        }
        const steps = Object.keys(reached).map(Number),
          most = steps[steps.length - 1];
        const wrong = [];
        for (const step of [most - 1, 1, Math.ceil(most / 2), most, Math.ceil(most / 3)]) {
          if (step < 1) continue;
          engine.goTo(step);
          if (all() !== reached[step]) wrong.push(step);
        }
        const colours = new Set();
        for (const step of [0, Math.ceil(most / 3)]) {
          engine.goTo(step); // what is fast has left the picture by then
          player.target = engine.now;
          player.stage.draw();
          const gl = player.stage.canvas.getContext("webgl2");
          const pixels = new Uint8Array(4 * gl.drawingBufferWidth * gl.drawingBufferHeight);
          gl.readPixels(0, 0, gl.drawingBufferWidth, gl.drawingBufferHeight, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
          for (let i = 0; i < pixels.length; i += 4 * 37)
            colours.add((pixels[i] << 16) | (pixels[i + 1] << 8) | pixels[i + 2]);
        }
        const numbers = engine.scene.numbers.map((_, i) => engine.number(0, i)[0]);
        return { wrong, most, colours: colours.size, problem: player.stage.problem, numbers, name: engine.scene.name };
      }, scene);
      assert.deepEqual(seen.wrong, [], `${seen.name}: other bits`);
      assert.equal(seen.problem, "", seen.name);
      assert.ok(seen.colours > 20, `${seen.name}: only ${seen.colours} colours`);
      assert.ok(
        seen.numbers.every((text) => text.length > 0),
        `${seen.name}: ${seen.numbers}`,
      );
    }
    assert.deepEqual(page.wrong, []);
    await page.close();
  });
}

test("play, pause, a step on, a step back, the time line, the speed", async () => {
  const page = await running("03_baumgarte");
  assert.equal(await now(page), 0);
  await page.getByRole("button", { name: "One step on" }).click();
  await page.getByRole("button", { name: "One step on" }).click();
  assert.equal(await now(page), 2);
  const two = await bits(page);
  await page.getByRole("button", { name: "One step on" }).click();
  await page.getByRole("button", { name: "One step back" }).click();
  assert.equal(await now(page), 2);
  assert.deepEqual(await bits(page), two);
  await page.getByRole("slider", { name: "Time", exact: true }).fill("30");
  await settled(page);
  assert.equal(await now(page), 30);
  await page.getByRole("slider", { name: "Time", exact: true }).fill("2");
  await settled(page);
  assert.deepEqual(await bits(page), two);
  await page.getByRole("button", { name: "To the start" }).click();
  assert.equal(await now(page), 0);
  await page.getByRole("combobox", { name: "Speed" }).selectOption({ label: "1/32 of real time" });
  assert.equal(await page.evaluate(() => player.speed), 1 / 32);
  await page.getByRole("combobox", { name: "Speed" }).selectOption({ label: "8 times as fast" });
  await page.getByRole("button", { name: "Play" }).click();
  await page.waitForFunction(() => !player.playing && player.engine.now === player.engine.steps);
  await page.getByRole("combobox", { name: "Speed" }).selectOption({ label: "1/32 of real time" });
  await page.getByRole("button", { name: "Play" }).click();
  assert.ok(await page.evaluate(() => player.playing));
  await page.getByRole("button", { name: "Pause" }).click();
  assert.equal(await page.evaluate(() => player.playing), false);
  assert.deepEqual(page.wrong, []);
  await page.close();
});

test("sliders are the parameters of --help, with range and reset, and change what is simulated; numbers follow", async () => {
  const page = await running("03_baumgarte");
  await seek(page, 20);
  const usual = await bits(page);
  assert.deepEqual(
    await page.evaluate(() =>
      player.engine.parameters.map(({ flag, symbol, unit, least, most }) => [flag, symbol, unit, least, most]),
    ),
    [
      ["--beta", "β", "", 0, 2],
      ["--depth", "d₀", "m", 0.001, 0.2],
      ["--unstable", "", "m/s", 0.001, 10],
      ["--sweeps", "", "", 1, 200],
      ["--dt", "h", "s", 0.001, 0.1],
      ["--seconds", "", "s", 0.1, 120],
    ],
  );
  const depth = page.getByRole("spinbutton", { name: "Overlap at the start, as a number" });
  await depth.fill("0.1");
  await depth.press("Enter");
  await settled(page);
  assert.equal(await now(page), 20);
  assert.notDeepEqual(await bits(page), usual);
  assert.match(await page.evaluate(() => player.engine.scene.name), /^100 mm too deep/);
  assert.ok((await page.evaluate(() => player.answer.first)) <= 2);
  await page.getByRole("button", { name: "Reset: Overlap at the start" }).click();
  await settled(page);
  assert.deepEqual(await bits(page), usual);
  await page.getByRole("slider", { name: "Baumgarte factors to put side by side, 4 of 4" }).fill("280");
  await settled(page);
  assert.deepEqual(await page.evaluate(() => player.engine.values["--beta"]), [0, 0.2, 0.5, 1.4]);
  assert.deepEqual(await page.evaluate(() => player.engine.lanes.map(({ name }) => name)), [
    "β = 0",
    "β = 0.2",
    "β = 0.5",
    "β = 1.4",
  ]);
  await page.getByRole("button", { name: "Leave out: Baumgarte factors to put side by side, 1 of 4" }).click();
  await settled(page);
  assert.equal(await page.evaluate(() => player.engine.lanes.length), 3);
  await page.getByRole("button", { name: "One more: Baumgarte" }).click();
  await settled(page);
  assert.equal(await page.evaluate(() => player.engine.lanes.length), 4);
  await depth.fill("5");
  await depth.press("Enter");
  assert.match(
    await page.getByRole("alert").textContent(),
    /--depth: '5' is not allowed: a number from 0.001 to 0.2 is needed/,
  );
  assert.deepEqual(page.wrong, []);
  await page.close();
});

test("where pictures take long, those of a slider that moves are coarse, and the one where it rests is not", async () => {
  const page = await running("03_baumgarte");
  await page.waitForFunction(() => player.stage.cost > 0 && !player.stage.drawing);
  const whole = await page.evaluate(() => player.stage.canvas.width);
  const moved = (cost) =>
    page.evaluate((ms) => {
      const slider = document.querySelector('.pb-sliders [data-flag="--depth"] input[type="range"]');
      player.stage.cost = ms;
      slider.value = Number(slider.value) + 9;
      slider.dispatchEvent(new Event("input"));
      player.stage.draw();
      return player.stage.canvas.width;
    }, cost);
  assert.ok(Math.abs((await moved(1000)) / whole - 0.4) < 0.01);
  await page.waitForFunction((width) => !player.stage.coarse && player.stage.canvas.width === width, whole);
  assert.equal(await moved(10), whole);
  assert.deepEqual(page.wrong, []);
  await page.close();
});

test("a slider is answered by a picture after two slices of steps at most, however long all of them take", async () => {
  const page = await running("14_joints_under_load");
  for (const name of ["a suspension bridge, and three boxes", "a rope hung at both ends", "a cloth over a ball"]) {
    await page.getByRole("combobox", { name: "Scene" }).selectOption({ label: name });
    await seek(page, 60);
    await page.waitForFunction(() => !player.stage.drawing && !player.stage.coarse && !player.asked);
    const waiting = await page.evaluate(async () => {
      const { stage } = player,
        draw = stage.draw.bind(stage);
      let waiting = 0;
      stage.draw = () => {
        if (stage.drawing) ++waiting;
        draw();
      };
      const slider = document.querySelector('.pb-sliders [data-flag="--beta"] input[type="range"]');
      const move = () => {
        slider.value = Number(slider.value) + 9;
        slider.dispatchEvent(new Event("input"));
      };
      for (let moved = 0; moved < 4; ++moved) {
        move();
        await new Promise((resolve) => setTimeout(resolve, 30));
      }
      while (!player.answer.complete || stage.coarse || stage.drawing || player.asked)
        await new Promise((resolve) => setTimeout(resolve, 20));
      move();
      return waiting;
    });
    await page.waitForFunction(() => player.answer.complete);
    assert.equal(waiting, 0, `${name}: pictures stand in line`);
    const { first, shown, complete, slices } = await page.evaluate(() => player.answer);
    assert.ok(first <= 2, `${name}: the first picture after ${first} slices`);
    assert.equal(await now(page), 60);
    console.log(
      `${name}: a picture after ${Math.round(shown)} ms, all after ${Math.round(complete)} ms, ${slices} slices`,
    );
  }
  assert.deepEqual(page.wrong, []);
  await page.close();
});

test("a telephone's camera stays close to what rolls away and to what falls", async () => {
  for (const chapter of ["05_restitution", "21_detected_once"]) {
    const page = await running(chapter, { viewport: { width: 390, height: 844 } });
    assert.ok(await page.evaluate(() => player.stage.follow));
    for (const part of [0, 0.14, 0.3, 0.5, 1]) {
      await seek(page, await page.evaluate((part) => Math.round(part * player.engine.steps), part));
      const found = await page.evaluate(() => {
        const { stage } = player,
          { left, top, width, height } = stage.panes[0];
        let seen = false;
        for (let y = 2; y < height && !seen; y += 4)
          for (let x = 2; x < width && !seen; x += 4) seen = Boolean(stage.grabAt(left + x, top + y, 0));
        player.engine.letGo();
        return seen;
      });
      assert.ok(found, `${chapter}: nothing in the picture after ${part} of the time`);
    }
    await page.close();
  }
});

test("numbers stand beside what they should be, and change with the time", async () => {
  const page = await running("03_baumgarte");
  await page.getByRole("combobox", { name: "Scene" }).selectOption({ index: 1 });
  await seek(page, 10);
  const row = page.getByRole("row", { name: /exit speed/ });
  await page.waitForFunction(() => /\(should be/.test(document.querySelector(".pb-numbers tbody").textContent));
  const [is, should] = await page.evaluate(() => player.engine.number(0, 0));
  assert.equal(should, "0.72 m/s"); // 0.2 * 0.06 m * 60/s
  assert.ok((await row.textContent()).includes(is));
  assert.equal(is, should);
  await page.close();
});

test("scenes and variants: up to four, a wipe between two, each seen in its colour", async () => {
  const page = await running("03_baumgarte");
  assert.equal(await page.evaluate(() => player.engine.lanes.length), 4);
  await page.getByRole("checkbox", { name: "β = 0.5" }).uncheck();
  await page.getByRole("checkbox", { name: "β = 0", exact: true }).uncheck();
  assert.deepEqual(await page.evaluate(() => player.engine.lanes.map(({ name }) => name)), ["β = 0.2", "β = 1"]);
  await page.getByRole("checkbox", { name: "wipe" }).check();
  await page.waitForFunction(() => player.stage.wiping);
  await page.getByRole("slider", { name: "Where one variant ends" }).fill("250");
  assert.equal(await page.evaluate(() => player.stage.wipe), 0.25);
  await page.getByRole("combobox", { name: "Scene" }).selectOption({ index: 2 });
  assert.equal(await page.evaluate(() => player.engine.sceneIndex), 2);
  assert.deepEqual(page.wrong, []);
  await page.close();
});

test("the picture: contacts, impulses, camera by mouse and by keys", async () => {
  const page = await running("03_baumgarte");
  await seek(page, 6);
  const picture = () =>
    page.evaluate(() => {
      player.stage.draw();
      return player.stage.canvas.toDataURL();
    });
  const whole = await picture();
  for (const name of ["contact points", "impulses", "what should be"]) {
    await page.getByRole("checkbox", { name }).uncheck();
    assert.notEqual(await picture(), whole, name);
    await page.getByRole("checkbox", { name }).check();
    assert.equal(await picture(), whole, name);
  }
  const canvas = page.locator(".pb-canvas");
  await page.evaluate(() => scrollTo(0, 0));
  const box = await canvas.boundingBox();
  await page.mouse.move(box.x + 0.8 * box.width, box.y + 12);
  await page.mouse.down();
  await page.mouse.move(box.x + 0.7 * box.width, box.y + 40);
  await page.mouse.up();
  assert.ok(await page.evaluate(() => player.stage.camera.turn !== 0), "the camera turns");
  assert.equal(await page.evaluate(() => player.engine.known), 6);
  await canvas.focus();
  for (const [key, changes] of [
    ["ArrowLeft", "turn"],
    ["ArrowUp", "rise"],
    ["+", "zoom"],
  ]) {
    const before = await page.evaluate((what) => player.stage.camera[what], changes);
    await page.keyboard.press(key);
    assert.notEqual(await page.evaluate((what) => player.stage.camera[what], changes), before, key);
  }
  await page.keyboard.press("0");
  assert.ok(await page.evaluate(() => player.stage.camera.isReset));
  await page.keyboard.press(".");
  assert.equal(await now(page), 7);
  await page.keyboard.press(",");
  assert.equal(await now(page), 6);
  await page.keyboard.press("Space");
  assert.ok(await page.evaluate(() => player.playing));
  await page.keyboard.press("Space");
  assert.deepEqual(page.wrong, []);
  await page.close();
});

test("a body that is pulled follows in every variant; going back plays the pull again", async () => {
  const page = await running("03_baumgarte");
  await seek(page, 40);
  const untouched = await bits(page);
  await seek(page, 10);
  const at = await page.evaluate(() => {
    scrollTo(0, 0);
    const { stage, engine } = player;
    stage.draw();
    const pane = stage.panes[0],
      camera = stage.cameraFor(pane);
    const body = engine.bodies(0) - 1,
      shift = engine.shift();
    const place = engine.body(0, body).position.map((x, i) => x + shift[i]);
    // Seen from the front: metres to pixels.
    const high = 2 * (camera.eye[2] - place[2]) * Math.tan(camera.fieldOfView / 2);
    const box = stage.canvas.getBoundingClientRect();
    const spot = [
      box.left + pane.left + pane.width / 2 + ((place[0] - camera.target[0]) / high) * pane.height,
      box.top + pane.top + pane.height / 2 - ((place[1] - camera.target[1]) / high) * pane.height,
    ];
    return { spot, pixels: pane.height / high };
  });
  await page.mouse.move(...at.spot);
  await page.mouse.down();
  assert.ok(await page.evaluate(() => player.held && player.playing), "the body is held, and time goes on");
  await page.evaluate(() => {
    player.speed = 4;
  });
  await page.mouse.move(at.spot[0], at.spot[1] - 0.5 * at.pixels, { steps: 3 });
  await page.waitForFunction(() => player.engine.now >= 30 || !player.playing);
  await page.mouse.up();
  await page.evaluate(() => player.pause());
  await seek(page, 40);
  const pulled = await bits(page);
  assert.notDeepEqual(pulled, untouched);
  for (let lane = 0; lane < pulled.length; ++lane) assert.notEqual(pulled[lane], untouched[lane], `variant ${lane}`);
  await seek(page, 5);
  await seek(page, 40);
  assert.deepEqual(await bits(page), pulled);
  assert.deepEqual(page.wrong, []);
  await page.close();
});

test("the address holds the state, also of what does not fit", async () => {
  const page = await running("03_baumgarte");
  await page.evaluate(() => player.controls.change(player.engine.parameters[0], [0.2, 1.4], true));
  await page.getByRole("checkbox", { name: "impulses" }).uncheck();
  await seek(page, 12);
  await page.evaluate(() => player.stage.camera.orbit(0.3, 0.1));
  await page.evaluate(() => player.remember());
  await page.waitForFunction(
    () =>
      location.hash.includes("beta=0.2%2C1.4") && location.hash.includes("step=12") && location.hash.includes("view="),
  );
  const seen = await bits(page),
    address = page.url();
  await page.close();
  const again = await newPage(browser, still);
  await again.goto(address);
  await again.waitForFunction(() => (window.player = window.PUSHBACK_LIVE_TEST.player()) && player.engine.now === 12);
  assert.deepEqual(await bits(again), seen);
  assert.equal(await again.evaluate(() => player.shown), 5);
  assert.deepEqual(
    await again.evaluate(() => [player.stage.camera.turn, player.stage.camera.rise].map((x) => x.toFixed(2))),
    ["0.30", "0.10"],
  );
  assert.deepEqual(again.wrong, []);
  await again.goto(`${address.split("#")[0]}#live=03_baumgarte&beta=9&scene=nowhere&show=7&step=-4&view=1,2&wipe=7`);
  await again.reload();
  await again.waitForFunction(() => (window.player = window.PUSHBACK_LIVE_TEST.player()));
  assert.match(await again.getByRole("alert").textContent(), /--beta: '9' is not allowed/);
  assert.equal(await now(again), 0);
  await again.close();
});

test("a picture to keep, with the parameters on it", async () => {
  const page = await running("03_baumgarte");
  await seek(page, 12);
  const [download] = await Promise.all([
    page.waitForEvent("download"),
    page.getByRole("button", { name: "save as a picture" }).click(),
  ]);
  assert.equal(download.suggestedFilename(), "03_baumgarte_gravity.png");
  const words = await page.evaluate(() => window.PushbackLive.parametersInWords(player));
  assert.match(words, /β = 0, 0.2, 0.5, 1 {2}· {2}d₀ = 0.06 m .*h = 0.01667 s/);
  await page.close();
});

test("curves: one a variant, a line at the instant, and a click goes there", async () => {
  const page = await running("03_baumgarte");
  await seek(page, 48);
  assert.equal(await page.locator(".pb-plot").count(), 1);
  await page.waitForFunction(() => player.curves.plots[0].plot.data[1].filter((y) => y !== null).length === 48);
  const over = page.locator(".pb-plot .u-over"),
    box = await over.boundingBox();
  await over.click({ position: { x: box.width / 2, y: box.height / 2 } });
  await settled(page);
  assert.equal(await now(page), 24);
  await page.close();
});

test("a page that asks for a guess waits for it, or for 'show me'", async () => {
  const page = await newPage(browser, still);
  await page.goto(pageOf("03_baumgarte", { guess: true }));
  const there = page.getByRole("button", { name: "Guess, then run it" }),
    here = page.getByRole("button", { name: "Run it", exact: true });
  assert.ok((await there.isDisabled()) && (await here.isDisabled()));
  await page.getByRole("textbox", { name: "Your guess" }).first().fill("half a metre");
  assert.ok(await here.isEnabled()); // the guess holds at both places
  await there.click();
  await page.waitForFunction(() => window.PUSHBACK_LIVE_TEST.player());
  await page.getByText("Your guess: half a metre").waitFor();
  await page.reload();
  await page.getByRole("button", { name: "Show me" }).click();
  await page.waitForFunction(() => window.PUSHBACK_LIVE_TEST.player());
  await page.close();
});

test("it plays by itself once it is asked for, but not where less motion is wanted", async () => {
  for (const [reducedMotion, plays] of [
    ["no-preference", true],
    ["reduce", false],
  ]) {
    const page = await newPage(browser, { reducedMotion });
    await page.goto(pageOf("03_baumgarte"));
    await page.getByRole("button", { name: "Run it here" }).click();
    await page.waitForFunction(() => (window.player = window.PUSHBACK_LIVE_TEST.player()));
    assert.equal(await page.evaluate(() => player.playing || player.engine.now > 0), plays);
    await page.close();
  }
});

test("a context that is lost: the still picture and a sentence, then the experiment again", async () => {
  const page = await running("03_baumgarte");
  await seek(page, 10);
  await page.evaluate(() => {
    window.loser = player.stage.canvas.getContext("webgl2").getExtension("WEBGL_lose_context");
    loser.loseContext();
  });
  await page.getByText("took the graphics of this page away").waitFor();
  assert.ok(await page.getByRole("img", { name: "The sheet" }).isVisible());
  await page.evaluate(() => loser.restoreContext());
  await page.waitForFunction(() => !player.stage.problem && !document.querySelector(".pb-still"));
  await page.evaluate(() => player.stage.draw());
  assert.equal(await page.evaluate(() => player.stage.problem), "");
  assert.equal(await now(page), 10);
  await page.close();
});

test("without WebGL: the still picture and a sentence; numbers and time go on", async () => {
  const other = await launch({ webgl: false });
  const page = await newPage(other, still);
  await page.goto(pageOf("03_baumgarte"));
  await page.getByRole("button", { name: "Run it here" }).click();
  await page.getByText("this browser shows no WebGL 2").waitFor();
  assert.ok(await page.getByRole("img", { name: "The sheet" }).isVisible());
  await page.getByRole("button", { name: "One step on" }).click();
  assert.equal(await page.evaluate(() => window.PUSHBACK_LIVE_TEST.player().engine.now), 1);
  await other.close();
});

test("a program that is not there: the still picture and a sentence", async () => {
  const page = await newPage(browser, still);
  await page.goto(pageOf("03_baumgarte"));
  await page.evaluate(() => {
    document.querySelector("figure.live").dataset.chapter = "99_none";
  });
  await page.getByRole("button", { name: "Run it here" }).click();
  await page.getByText("cannot be run here").waitFor();
  assert.ok(await page.getByRole("img", { name: "The sheet" }).isVisible());
  await page.close();
});

test("360 pixels wide: nothing is wider than the page", async () => {
  const page = await running("03_baumgarte", { viewport: { width: 360, height: 740 } });
  await seek(page, 20);
  assert.equal(await page.evaluate(() => document.documentElement.scrollWidth), 360);
  await page.close();
});
