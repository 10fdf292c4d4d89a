import { launch, newPage } from "./support/browser.mjs";
import fs from "node:fs";
const [folder, out, ...which] = process.argv.slice(2);
const b = await launch({draws:true});
fs.mkdirSync(out,{recursive:true});
for (const [size, options] of [["desktop",{viewport:{width:1280,height:800}}],["phone",{viewport:{width:390,height:844},hasTouch:true,isMobile:true,deviceScaleFactor:1}]]) for (const c of which) {
  const p = await newPage(b, options);
  await p.goto(`file://${folder}/chapters/${c}/index.html`);
  await p.locator("figure.live").scrollIntoViewIfNeeded();
  await p.evaluate(()=>document.querySelector("figure.live").scrollIntoView());
  await p.screenshot({path:`${out}/${c}_${size}_before.png`});
  await p.getByRole("button",{name:"Run it here"}).click();
  await p.waitForFunction(()=>window.PUSHBACK_LIVE_TEST.player());
  const heights = await p.evaluate(async()=>{const pl=window.PUSHBACK_LIVE_TEST.player(); const hs=[]; const t0=performance.now(); const note=()=>{const h=pl.view.stage.canvas.getBoundingClientRect().height; if(hs.at(-1)?.[1]!==h) hs.push([Math.round(performance.now()-t0),h,pl.engine.now]);};
    pl.play(); const s=setInterval(note,50); await new Promise(d=>{const f=()=>pl.playing&&performance.now()-t0<40000?setTimeout(f,100):d();f();}); await new Promise(d=>setTimeout(d,500)); note(); clearInterval(s); return [hs, pl.engine.now, pl.engine.steps, Math.round(performance.now()-t0), pl.speed, pl.view.stage.tab, pl.engine.scene.key];});
  console.log(c,size,JSON.stringify(heights));
  await p.screenshot({path:`${out}/${c}_${size}_end.png`});
  console.log(p.wrong);
  await p.close();
}
await b.close();
