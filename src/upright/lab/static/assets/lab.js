const rm="uplot",om="u-hz",am="u-vt",lm="u-title",cm="u-wrap",um="u-under",hm="u-over",dm="u-axis",bs="u-off",fm="u-select",pm="u-cursor-x",mm="u-cursor-y",gm="u-cursor-pt",_m="u-legend",vm="u-live",xm="u-inline",Mm="u-series",Sm="u-marker",qu="u-label",ym="u-value",no="width",io="height";const Yu="bottom",Zs="left",el="right",qc="#000",ju=qc+"0",tl="mousemove",Ku="mousedown",nl="mouseup",Zu="mouseenter",Ju="mouseleave",Qu="dblclick",bm="resize",Em="scroll",eh="change",ma="dppxchange",Yc="--",Dr=typeof window<"u",$l=Dr?document:null,mr=Dr?window:null,wm=Dr?navigator:null;let yt,Po;function Xl(){let i=devicePixelRatio;yt!=i&&(yt=i,Po&&Yl(eh,Po,Xl),Po=matchMedia(`(min-resolution: ${yt-.001}dppx) and (max-resolution: ${yt+.001}dppx)`),Cs(eh,Po,Xl),mr.dispatchEvent(new CustomEvent(ma)))}function In(i,e){if(e!=null){let t=i.classList;!t.contains(e)&&t.add(e)}}function ql(i,e){let t=i.classList;t.contains(e)&&t.remove(e)}function Ut(i,e,t){i.style[e]=t+"px"}function ei(i,e,t,n){let s=$l.createElement(i);return e!=null&&In(s,e),t?.insertBefore(s,n),s}function Gn(i,e){return ei("div",i,e)}const th=new WeakMap;function mi(i,e,t,n,s){let r="translate("+e+"px,"+t+"px)",o=th.get(i);r!=o&&(i.style.transform=r,th.set(i,r),e<0||t<0||e>n||t>s?In(i,bs):ql(i,bs))}const nh=new WeakMap;function ih(i,e,t){let n=e+t,s=nh.get(i);n!=s&&(nh.set(i,n),i.style.background=e,i.style.borderColor=t)}const sh=new WeakMap;function rh(i,e,t,n){let s=e+""+t,r=sh.get(i);s!=r&&(sh.set(i,s),i.style.height=t+"px",i.style.width=e+"px",i.style.marginLeft=n?-e/2+"px":0,i.style.marginTop=n?-t/2+"px":0)}const jc={passive:!0},Tm={...jc,capture:!0};function Cs(i,e,t,n){e.addEventListener(i,t,n?Tm:jc)}function Yl(i,e,t,n){e.removeEventListener(i,t,jc)}Dr&&Xl();function ti(i,e,t,n){let s;t=t||0,n=n||e.length-1;let r=n<=2147483647;for(;n-t>1;)s=r?t+n>>1:On((t+n)/2),e[s]<i?t=s:n=s;return i-e[t]<=e[n]-i?t:n}function Qd(i){return(t,n,s)=>{let r=-1,o=-1;for(let a=n;a<=s;a++)if(i(t[a])){r=a;break}for(let a=s;a>=n;a--)if(i(t[a])){o=a;break}return[r,o]}}const ef=i=>i!=null,tf=i=>i!=null&&i>0,Ra=Qd(ef),Am=Qd(tf);function Rm(i,e,t,n=0,s=!1){let r=s?Am:Ra,o=s?tf:ef;[e,t]=r(i,e,t);let a=i[e],l=i[e];if(e>-1)if(n==1)a=i[e],l=i[t];else if(n==-1)a=i[t],l=i[e];else for(let c=e;c<=t;c++){let u=i[c];o(u)&&(u<a?a=u:u>l&&(l=u))}return[a??Ct,l??-Ct]}function Ca(i,e,t,n){let s=lh(i),r=lh(e);i==e&&(s==-1?(i*=t,e/=t):(i/=t,e*=t));let o=t==10?Fi:nf,a=s==1?On:$n,l=r==1?$n:On,c=a(o(Zt(i))),u=l(o(Zt(e))),h=xr(t,c),d=xr(t,u);return t==10&&(c<0&&(h=Pt(h,-c)),u<0&&(d=Pt(d,-u))),n||t==2?(i=h*s,e=d*r):(i=af(i,h),e=Pa(e,d)),[i,e]}function Kc(i,e,t,n){let s=Ca(i,e,t,n);return i==0&&(s[0]=0),e==0&&(s[1]=0),s}const Zc=.1,oh={mode:3,pad:Zc},lo={pad:0,soft:null,mode:0},Cm={min:lo,max:lo};function ga(i,e,t,n){return La(t)?ah(i,e,t):(lo.pad=t,lo.soft=n?0:null,lo.mode=n?3:0,ah(i,e,Cm))}function vt(i,e){return i??e}function Pm(i,e,t){for(e=vt(e,0),t=vt(t,i.length-1);e<=t;){if(i[e]!=null)return!0;e++}return!1}function ah(i,e,t){let n=t.min,s=t.max,r=vt(n.pad,0),o=vt(s.pad,0),a=vt(n.hard,-Ct),l=vt(s.hard,Ct),c=vt(n.soft,Ct),u=vt(s.soft,-Ct),h=vt(n.mode,0),d=vt(s.mode,0),m=e-i,_=Fi(m),v=Sn(Zt(i),Zt(e)),p=Fi(v),f=Zt(p-_);(m<1e-24||f>10)&&(m=0,(i==0||e==0)&&(m=1e-24,h==2&&c!=Ct&&(r=0),d==2&&u!=-Ct&&(o=0)));let E=m||v||1e3,T=Fi(E),M=xr(10,On(T)),k=E*(m==0?i==0?.1:1:r),L=Pt(af(i-k,M/10),24),D=i>=c&&(h==1||h==3&&L<=c||h==2&&L>=c)?c:Ct,N=Sn(a,L<D&&i>=D?D:ni(D,L)),w=E*(m==0?e==0?.1:1:o),y=Pt(Pa(e+w,M/10),24),R=e<=u&&(d==1||d==3&&y>=u||d==2&&y<=u)?u:-Ct,V=ni(l,y>R&&e<=R?R:Sn(R,y));return N==V&&N==0&&(V=100),[N,V]}const Lm=new Intl.NumberFormat(Dr?wm.language:"en-US"),Jc=i=>Lm.format(i),kn=Math,la=kn.PI,Zt=kn.abs,On=kn.floor,Kt=kn.round,$n=kn.ceil,ni=kn.min,Sn=kn.max,xr=kn.pow,lh=kn.sign,Fi=kn.log10,nf=kn.log2,Dm=(i,e=1)=>kn.sinh(i)*e,il=(i,e=1)=>kn.asinh(i/e),Ct=1/0;function ch(i){return(Fi((i^i>>31)-(i>>31))|0)+1}function jl(i,e,t){return ni(Sn(i,e),t)}function sf(i){return typeof i=="function"}function ot(i){return sf(i)?i:()=>i}const Nm=()=>{},rf=i=>i,of=(i,e)=>e,Im=i=>null,uh=i=>!0,hh=(i,e)=>i==e,Um=/\.\d*?(?=9{6,}|0{6,})/gm,Ds=i=>{if(cf(i)||ss.has(i))return i;const e=`${i}`,t=e.match(Um);if(t==null)return i;let n=t[0].length-1;if(e.indexOf("e-")!=-1){let[s,r]=e.split("e");return+`${Ds(s)}e${r}`}return Pt(i,n)};function Ms(i,e){return Ds(Pt(Ds(i/e))*e)}function Pa(i,e){return Ds($n(Ds(i/e))*e)}function af(i,e){return Ds(On(Ds(i/e))*e)}function Pt(i,e=0){if(cf(i))return i;let t=10**e,n=i*t*(1+Number.EPSILON);return Kt(n)/t}const ss=new Map;function lf(i){return((""+i).split(".")[1]||"").length}function fo(i,e,t,n){let s=[],r=n.map(lf);for(let o=e;o<t;o++){let a=Zt(o),l=Pt(xr(i,o),a);for(let c=0;c<n.length;c++){let u=i==10?+`${n[c]}e${o}`:n[c]*l,h=(o>=0?0:a)+(o>=r[c]?0:r[c]),d=i==10?u:Pt(u,h);s.push(d),ss.set(d,h)}}return s}const co={},Qc=[],Mr=[null,null],Ji=Array.isArray,cf=Number.isInteger,Fm=i=>i===void 0;function dh(i){return typeof i=="string"}function La(i){let e=!1;if(i!=null){let t=i.constructor;e=t==null||t==Object}return e}function Om(i){return i!=null&&typeof i=="object"}const km=Object.getPrototypeOf(Uint8Array),uf="__proto__";function Sr(i,e=La){let t;if(Ji(i)){let n=i.find(s=>s!=null);if(Ji(n)||e(n)){t=Array(i.length);for(let s=0;s<i.length;s++)t[s]=Sr(i[s],e)}else t=i.slice()}else if(i instanceof km)t=i.slice();else if(e(i)){t={};for(let n in i)n!=uf&&(t[n]=Sr(i[n],e))}else t=i;return t}function qt(i){let e=arguments;for(let t=1;t<e.length;t++){let n=e[t];for(let s in n)s!=uf&&(La(i[s])?qt(i[s],Sr(n[s])):i[s]=Sr(n[s]))}return i}const Bm=0,zm=1,Hm=2;function Vm(i,e,t){for(let n=0,s,r=-1;n<e.length;n++){let o=e[n];if(o>r){for(s=o-1;s>=0&&i[s]==null;)i[s--]=null;for(s=o+1;s<t&&i[s]==null;)i[r=s++]=null}}}function Gm(i,e){if(Xm(i)){let o=i[0].slice();for(let a=1;a<i.length;a++)o.push(...i[a].slice(1));return qm(o[0])||(o=$m(o)),o}let t=new Set;for(let o=0;o<i.length;o++){let l=i[o][0],c=l.length;for(let u=0;u<c;u++)t.add(l[u])}let n=[Array.from(t).sort((o,a)=>o-a)],s=n[0].length,r=new Map;for(let o=0;o<s;o++)r.set(n[0][o],o);for(let o=0;o<i.length;o++){let a=i[o],l=a[0];for(let c=1;c<a.length;c++){let u=a[c],h=Array(s).fill(void 0),d=e?e[o][c]:zm,m=[];for(let _=0;_<u.length;_++){let v=u[_],p=r.get(l[_]);v===null?d!=Bm&&(h[p]=v,d==Hm&&m.push(p)):h[p]=v}Vm(h,m,s),n.push(h)}}return n}const Wm=typeof queueMicrotask>"u"?i=>Promise.resolve().then(i):queueMicrotask;function $m(i){let e=i[0],t=e.length,n=Array(t);for(let r=0;r<n.length;r++)n[r]=r;n.sort((r,o)=>e[r]-e[o]);let s=[];for(let r=0;r<i.length;r++){let o=i[r],a=Array(t);for(let l=0;l<t;l++)a[l]=o[n[l]];s.push(a)}return s}function Xm(i){let e=i[0][0],t=e.length;for(let n=1;n<i.length;n++){let s=i[n][0];if(s.length!=t)return!1;if(s!=e){for(let r=0;r<t;r++)if(s[r]!=e[r])return!1}}return!0}function qm(i,e=100){const t=i.length;if(t<=1)return!0;let n=0,s=t-1;for(;n<=s&&i[n]==null;)n++;for(;s>=n&&i[s]==null;)s--;if(s<=n)return!0;const r=Sn(1,On((s-n+1)/e));for(let o=i[n],a=n+r;a<=s;a+=r){const l=i[a];if(l!=null){if(l<=o)return!1;o=l}}return!0}const hf=["January","February","March","April","May","June","July","August","September","October","November","December"],df=["Sunday","Monday","Tuesday","Wednesday","Thursday","Friday","Saturday"];function ff(i){return i.slice(0,3)}const Ym=df.map(ff),jm=hf.map(ff),Km={MMMM:hf,MMM:jm,WWWW:df,WWW:Ym};function Xr(i){return(i<10?"0":"")+i}function Zm(i){return(i<10?"00":i<100?"0":"")+i}const Jm={YYYY:i=>i.getFullYear(),YY:i=>(i.getFullYear()+"").slice(2),MMMM:(i,e)=>e.MMMM[i.getMonth()],MMM:(i,e)=>e.MMM[i.getMonth()],MM:i=>Xr(i.getMonth()+1),M:i=>i.getMonth()+1,DD:i=>Xr(i.getDate()),D:i=>i.getDate(),WWWW:(i,e)=>e.WWWW[i.getDay()],WWW:(i,e)=>e.WWW[i.getDay()],HH:i=>Xr(i.getHours()),H:i=>i.getHours(),h:i=>{let e=i.getHours();return e==0?12:e>12?e-12:e},AA:i=>i.getHours()>=12?"PM":"AM",aa:i=>i.getHours()>=12?"pm":"am",a:i=>i.getHours()>=12?"p":"a",mm:i=>Xr(i.getMinutes()),m:i=>i.getMinutes(),ss:i=>Xr(i.getSeconds()),s:i=>i.getSeconds(),fff:i=>Zm(i.getMilliseconds())};function eu(i,e){e=e||Km;let t=[],n=/\{([a-z]+)\}|[^{]+/gi,s;for(;s=n.exec(i);)t.push(s[0][0]=="{"?Jm[s[1]]:s[0]);return r=>{let o="";for(let a=0;a<t.length;a++)o+=typeof t[a]=="string"?t[a]:t[a](r,e);return o}}const Qm=new Intl.DateTimeFormat().resolvedOptions().timeZone;function eg(i,e){let t;return e=="UTC"||e=="Etc/UTC"?t=new Date(+i+i.getTimezoneOffset()*6e4):e==Qm?t=i:(t=new Date(i.toLocaleString("en-US",{timeZone:e})),t.setMilliseconds(i.getMilliseconds())),t}const pf=i=>i%1==0,_a=[1,2,2.5,5],tg=fo(10,-32,0,_a),mf=fo(10,0,32,_a),ng=mf.filter(pf),Ss=tg.concat(mf),tu=`
`,gf="{YYYY}",fh=tu+gf,_f="{M}/{D}",so=tu+_f,Lo=so+"/{YY}",vf="{aa}",ig="{h}:{mm}",fr=ig+vf,ph=tu+fr,mh=":{ss}",Et=null;function xf(i){let e=i*1e3,t=e*60,n=t*60,s=n*24,r=s*30,o=s*365,l=(i==1?fo(10,0,3,_a).filter(pf):fo(10,-3,0,_a)).concat([e,e*5,e*10,e*15,e*30,t,t*5,t*10,t*15,t*30,n,n*2,n*3,n*4,n*6,n*8,n*12,s,s*2,s*3,s*4,s*5,s*6,s*7,s*8,s*9,s*10,s*15,r,r*2,r*3,r*4,r*6,o,o*2,o*5,o*10,o*25,o*50,o*100]);const c=[[o,gf,Et,Et,Et,Et,Et,Et,1],[s*28,"{MMM}",fh,Et,Et,Et,Et,Et,1],[s,_f,fh,Et,Et,Et,Et,Et,1],[n,"{h}"+vf,Lo,Et,so,Et,Et,Et,1],[t,fr,Lo,Et,so,Et,Et,Et,1],[e,mh,Lo+" "+fr,Et,so+" "+fr,Et,ph,Et,1],[i,mh+".{fff}",Lo+" "+fr,Et,so+" "+fr,Et,ph,Et,1]];function u(h){return(d,m,_,v,p,f)=>{let E=[],T=p>=o,M=p>=r&&p<o,k=h(_),L=Pt(k*i,3),D=sl(k.getFullYear(),T?0:k.getMonth(),M||T?1:k.getDate()),N=Pt(D*i,3);if(M||T){let w=M?p/r:0,y=T?p/o:0,R=L==N?L:Pt(sl(D.getFullYear()+y,D.getMonth()+w,1)*i,3),V=new Date(Kt(R/i)),U=V.getFullYear(),K=V.getMonth();for(let X=0;R<=v;X++){let Q=sl(U+y*X,K+w*X,1),J=Q-h(Pt(Q*i,3));R=Pt((+Q+J)*i,3),R<=v&&E.push(R)}}else{let w=p>=s?s:p,y=On(_)-On(L),R=N+y+Pa(L-N,w);E.push(R);let V=h(R),U=V.getHours()+V.getMinutes()/t+V.getSeconds()/n,K=p/n,X=d.axes[m]._space,Q=f/X;for(;R=Pt(R+p,i==1?0:3),!(R>v);)if(K>1){let J=On(Pt(U+K,6))%24,he=h(R).getHours()-J;he>1&&(he=-1),R-=he*n,U=(U+K)%24;let _e=E[E.length-1];Pt((R-_e)/p,3)*Q>=.7&&E.push(R)}else E.push(R)}return E}}return[l,c,u]}const[sg,rg,og]=xf(1),[ag,lg,cg]=xf(.001);fo(2,-53,53,[1]);function gh(i,e){return i.map(t=>t.map((n,s)=>s==0||s==8||n==null?n:e(s==1||t[8]==0?n:t[1]+n)))}function _h(i,e){return(t,n,s,r,o)=>{let a=e.find(_=>o>=_[0])||e[e.length-1],l,c,u,h,d,m;return n.map(_=>{let v=i(_),p=v.getFullYear(),f=v.getMonth(),E=v.getDate(),T=v.getHours(),M=v.getMinutes(),k=v.getSeconds(),L=p!=l&&a[2]||f!=c&&a[3]||E!=u&&a[4]||T!=h&&a[5]||M!=d&&a[6]||k!=m&&a[7]||a[1];return l=p,c=f,u=E,h=T,d=M,m=k,L(v)})}}function ug(i,e){let t=eu(e);return(n,s,r,o,a)=>s.map(l=>t(i(l)))}function sl(i,e,t){return new Date(i,e,t)}function vh(i,e){return e(i)}const hg="{YYYY}-{MM}-{DD} {h}:{mm}{aa}";function xh(i,e){return(t,n,s,r)=>r==null?Yc:e(i(n))}function dg(i,e){let t=i.series[e];return t.width?t.stroke(i,e):t.points.width?t.points.stroke(i,e):null}function fg(i,e){return i.series[e].fill(i,e)}const pg={show:!0,live:!0,isolate:!1,mount:Nm,markers:{show:!0,width:2,stroke:dg,fill:fg,dash:"solid"},idx:null,idxs:null,values:[]};function mg(i,e){let t=i.cursor.points,n=Gn(),s=t.size(i,e);Ut(n,no,s),Ut(n,io,s);let r=s/-2;Ut(n,"marginLeft",r),Ut(n,"marginTop",r);let o=t.width(i,e,s);return o&&Ut(n,"borderWidth",o),n}function gg(i,e){let t=i.series[e].points;return t._fill||t._stroke}function _g(i,e){let t=i.series[e].points;return t._stroke||t._fill}function vg(i,e){return i.series[e].points.size}const rl=[0,0];function xg(i,e,t){return rl[0]=e,rl[1]=t,rl}function Do(i,e,t,n=!0){return s=>{s.button==0&&(!n||s.target==e)&&t(s)}}function ol(i,e,t,n=!0){return s=>{(!n||s.target==e)&&t(s)}}const Mg={show:!0,x:!0,y:!0,lock:!1,move:xg,points:{one:!1,show:mg,size:vg,width:0,stroke:_g,fill:gg},bind:{mousedown:Do,mouseup:Do,click:Do,dblclick:Do,mousemove:ol,mouseleave:ol,mouseenter:ol},drag:{setScale:!0,x:!0,y:!1,dist:0,uni:null,click:(i,e)=>{e.stopPropagation(),e.stopImmediatePropagation()},_x:!1,_y:!1},focus:{dist:(i,e,t,n,s)=>n-s,prox:-1,bias:0},hover:{skip:[void 0],prox:null,bias:0},left:-10,top:-10,idx:null,dataIdx:null,idxs:null,event:null},Mf={show:!0,stroke:"rgba(0,0,0,0.07)",width:2},nu=qt({},Mf,{filter:of}),Sf=qt({},nu,{size:10}),yf=qt({},Mf,{show:!1}),iu='12px system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, "Noto Sans", sans-serif, "Apple Color Emoji", "Segoe UI Emoji", "Segoe UI Symbol", "Noto Color Emoji"',bf="bold "+iu,Ef=1.5,Mh={show:!0,scale:"x",stroke:qc,space:50,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:bf,side:2,grid:nu,ticks:Sf,border:yf,font:iu,lineGap:Ef,rotate:0},Sg="Value",yg="Time",Sh={show:!0,scale:"x",auto:!1,sorted:1,min:Ct,max:-Ct,idxs:[]};function bg(i,e,t,n,s){return e.map(r=>r==null?"":Jc(r))}function Eg(i,e,t,n,s,r,o){let a=[],l=ss.get(s)||0;t=o?t:Pt(Pa(t,s),l);for(let c=t;c<=n;c=Pt(c+s,l))a.push(Object.is(c,-0)?0:c);return a}function Kl(i,e,t,n,s,r,o){const a=[],l=i.scales[i.axes[e].scale].log,c=l==10?Fi:nf,u=On(c(t));s=xr(l,u),l==10&&(s=Ss[ti(s,Ss)]);let h=t,d=s*l;l==10&&(d=Ss[ti(d,Ss)]);do a.push(h),h=h+s,l==10&&!ss.has(h)&&(h=Pt(h,ss.get(s))),h>=d&&(s=h,d=s*l,l==10&&(d=Ss[ti(d,Ss)]));while(h<=n);return a}function wg(i,e,t,n,s,r,o){let l=i.scales[i.axes[e].scale].asinh,c=n>l?Kl(i,e,Sn(l,t),n,s):[l],u=n>=0&&t<=0?[0]:[];return(t<-l?Kl(i,e,Sn(l,-n),-t,s):[l]).reverse().map(d=>-d).concat(u,c)}const wf=/./,Tg=/[12357]/,Ag=/[125]/,yh=/1/,Zl=(i,e,t,n)=>i.map((s,r)=>e==4&&s==0||r%n==0&&t.test(s.toExponential()[s<0?1:0])?s:null);function Rg(i,e,t,n,s){let r=i.axes[t],o=r.scale,a=i.scales[o],l=i.valToPos,c=r._space,u=l(10,o),h=l(9,o)-u>=c?wf:l(7,o)-u>=c?Tg:l(5,o)-u>=c?Ag:yh;if(h==yh){let d=Zt(l(1,o)-u);if(d<c)return Zl(e.slice().reverse(),a.distr,h,$n(c/d)).reverse()}return Zl(e,a.distr,h,1)}function Cg(i,e,t,n,s){let r=i.axes[t],o=r.scale,a=r._space,l=i.valToPos,c=Zt(l(1,o)-l(2,o));return c<a?Zl(e.slice().reverse(),3,wf,$n(a/c)).reverse():e}function Pg(i,e,t,n){return n==null?Yc:e==null?"":Jc(e)}const bh={show:!0,scale:"y",stroke:qc,space:30,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:bf,side:3,grid:nu,ticks:Sf,border:yf,font:iu,lineGap:Ef,rotate:0};function Lg(i,e){let t=3+(i||1)*2;return Pt(t*e,3)}function Dg(i,e){let{scale:t,idxs:n}=i.series[0],s=i._data[0],r=i.valToPos(s[n[0]],t,!0),o=i.valToPos(s[n[1]],t,!0),a=Zt(o-r),l=i.series[e],c=a/(l.points.space*yt);return n[1]-n[0]<=c}const Eh={scale:null,auto:!0,sorted:0,min:Ct,max:-Ct},Tf=(i,e,t,n,s)=>s,wh={show:!0,auto:!0,sorted:0,gaps:Tf,alpha:1,facets:[qt({},Eh,{scale:"x"}),qt({},Eh,{scale:"y"})]},Th={scale:"y",auto:!0,sorted:0,show:!0,spanGaps:!1,gaps:Tf,alpha:1,points:{show:Dg,filter:null},values:null,min:Ct,max:-Ct,idxs:[],path:null,clip:null};function Ng(i,e,t,n,s){return t/10}const Af={time:!0,auto:!0,distr:1,log:10,asinh:1,min:null,max:null,dir:1,ori:0},Ig=qt({},Af,{time:!1,ori:1}),Ah={};function Rf(i,e){let t=Ah[i];return t||(t={key:i,plots:[],sub(n){t.plots.push(n)},unsub(n){t.plots=t.plots.filter(s=>s!=n)},pub(n,s,r,o,a,l,c){for(let u=0;u<t.plots.length;u++)t.plots[u]!=s&&t.plots[u].pub(n,s,r,o,a,l,c)}},i!=null&&(Ah[i]=t)),t}const yr=1,Jl=2;function ks(i,e,t){const n=i.mode,s=i.series[e],r=n==2?i._data[e]:i._data,o=i.scales,a=i.bbox;let l=r[0],c=n==2?r[1]:r[e],u=n==2?o[s.facets[0].scale]:o[i.series[0].scale],h=n==2?o[s.facets[1].scale]:o[s.scale],d=a.left,m=a.top,_=a.width,v=a.height,p=i.valToPosH,f=i.valToPosV;return u.ori==0?t(s,l,c,u,h,p,f,d,m,_,v,Na,Nr,Ua,Pf,Df):t(s,l,c,u,h,f,p,m,d,v,_,Ia,Ir,ou,Lf,Nf)}function su(i,e){let t=0,n=0,s=vt(i.bands,Qc);for(let r=0;r<s.length;r++){let o=s[r];o.series[0]==e?t=o.dir:o.series[1]==e&&(o.dir==1?n|=1:n|=2)}return[t,n==1?-1:n==2?1:n==3?2:0]}function Ug(i,e,t,n,s){let r=i.mode,o=i.series[e],a=r==2?o.facets[1].scale:o.scale,l=i.scales[a];return s==-1?l.min:s==1?l.max:l.distr==3?l.dir==1?l.min:l.max:0}function Oi(i,e,t,n,s,r){return ks(i,e,(o,a,l,c,u,h,d,m,_,v,p)=>{let f=o.pxRound;const E=c.dir*(c.ori==0?1:-1),T=c.ori==0?Nr:Ir;let M,k;E==1?(M=t,k=n):(M=n,k=t);let L=f(h(a[M],c,v,m)),D=f(d(l[M],u,p,_)),N=f(h(a[k],c,v,m)),w=f(d(r==1?u.max:u.min,u,p,_)),y=new Path2D(s);return T(y,N,w),T(y,L,w),T(y,L,D),y})}function Da(i,e,t,n,s,r){let o=null;if(i.length>0){o=new Path2D;const a=e==0?Ua:ou;let l=t;for(let h=0;h<i.length;h++){let d=i[h];if(d[1]>d[0]){let m=d[0]-l;m>0&&a(o,l,n,m,n+r),l=d[1]}}let c=t+s-l,u=10;c>0&&a(o,l,n-u/2,c,n+r+u)}return o}function Fg(i,e,t){let n=i[i.length-1];n&&n[0]==e?n[1]=t:i.push([e,t])}function ru(i,e,t,n,s,r,o){let a=[],l=i.length;for(let c=s==1?t:n;c>=t&&c<=n;c+=s)if(e[c]===null){let h=c,d=c;if(s==1)for(;++c<=n&&e[c]===null;)d=c;else for(;--c>=t&&e[c]===null;)d=c;let m=r(i[h]),_=d==h?m:r(i[d]),v=h-s;m=o<=0&&v>=0&&v<l?r(i[v]):m;let f=d+s;_=o>=0&&f>=0&&f<l?r(i[f]):_,_>=m&&a.push([m,_])}return a}function Rh(i){return i==0?rf:i==1?Kt:e=>Ms(e,i)}function Cf(i){let e=i==0?Na:Ia,t=i==0?(s,r,o,a,l,c)=>{s.arcTo(r,o,a,l,c)}:(s,r,o,a,l,c)=>{s.arcTo(o,r,l,a,c)},n=i==0?(s,r,o,a,l)=>{s.rect(r,o,a,l)}:(s,r,o,a,l)=>{s.rect(o,r,l,a)};return(s,r,o,a,l,c=0,u=0)=>{c==0&&u==0?n(s,r,o,a,l):(c=ni(c,a/2,l/2),u=ni(u,a/2,l/2),e(s,r+c,o),t(s,r+a,o,r+a,o+l,c),t(s,r+a,o+l,r,o+l,u),t(s,r,o+l,r,o,u),t(s,r,o,r+a,o,c),s.closePath())}}const Na=(i,e,t)=>{i.moveTo(e,t)},Ia=(i,e,t)=>{i.moveTo(t,e)},Nr=(i,e,t)=>{i.lineTo(e,t)},Ir=(i,e,t)=>{i.lineTo(t,e)},Ua=Cf(0),ou=Cf(1),Pf=(i,e,t,n,s,r)=>{i.arc(e,t,n,s,r)},Lf=(i,e,t,n,s,r)=>{i.arc(t,e,n,s,r)},Df=(i,e,t,n,s,r,o)=>{i.bezierCurveTo(e,t,n,s,r,o)},Nf=(i,e,t,n,s,r,o)=>{i.bezierCurveTo(t,e,s,n,o,r)};function If(i){return(e,t,n,s,r)=>ks(e,t,(o,a,l,c,u,h,d,m,_,v,p)=>{let{pxRound:f,points:E}=o,T,M;c.ori==0?(T=Na,M=Pf):(T=Ia,M=Lf);const k=Pt(E.width*yt,3);let L=(E.size-E.width)/2*yt,D=Pt(L*2,3),N=new Path2D,w=new Path2D,{left:y,top:R,width:V,height:U}=e.bbox;Ua(w,y-D,R-D,V+D*2,U+D*2);const K=X=>{if(l[X]!=null){let Q=f(h(a[X],c,v,m)),J=f(d(l[X],u,p,_));T(N,Q+L,J),M(N,Q,J,L,0,la*2)}};if(r)r.forEach(K);else for(let X=n;X<=s;X++)K(X);return{stroke:k>0?N:null,fill:N,clip:w,flags:yr|Jl}})}function Uf(i){return(e,t,n,s,r,o)=>{n!=s&&(r!=n&&o!=n&&i(e,t,n),r!=s&&o!=s&&i(e,t,s),i(e,t,o))}}const Og=Uf(Nr),kg=Uf(Ir);function Ff(i){const e=vt(i?.alignGaps,0);return(t,n,s,r)=>ks(t,n,(o,a,l,c,u,h,d,m,_,v,p)=>{[s,r]=Ra(l,s,r);let f=o.pxRound,E=U=>f(h(U,c,v,m)),T=U=>f(d(U,u,p,_)),M,k;c.ori==0?(M=Nr,k=Og):(M=Ir,k=kg);const L=c.dir*(c.ori==0?1:-1),D={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:yr},N=D.stroke;let w=!1;if(r-s>=v*4){let U=ge=>t.posToVal(ge,c.key,!0),K=null,X=null,Q,J,ne,fe=E(a[L==1?s:r]),he=E(a[s]),_e=E(a[r]),ye=U(L==1?he+1:_e-1);for(let ge=L==1?s:r;ge>=s&&ge<=r;ge+=L){let re=a[ge],ve=(L==1?re<ye:re>ye)?fe:E(re),le=l[ge];ve==fe?le!=null?(J=le,K==null?(M(N,ve,T(J)),Q=K=X=J):J<K?K=J:J>X&&(X=J)):le===null&&(w=!0):(K!=null&&k(N,fe,T(K),T(X),T(Q),T(J)),le!=null?(J=le,M(N,ve,T(J)),K=X=Q=J):(K=X=null,le===null&&(w=!0)),fe=ve,ye=U(fe+L))}K!=null&&K!=X&&ne!=fe&&k(N,fe,T(K),T(X),T(Q),T(J))}else for(let U=L==1?s:r;U>=s&&U<=r;U+=L){let K=l[U];K===null?w=!0:K!=null&&M(N,E(a[U]),T(K))}let[R,V]=su(t,n);if(o.fill!=null||R!=0){let U=D.fill=new Path2D(N),K=o.fillTo(t,n,o.min,o.max,R),X=T(K),Q=E(a[s]),J=E(a[r]);L==-1&&([J,Q]=[Q,J]),M(U,J,X),M(U,Q,X)}if(!o.spanGaps){let U=[];w&&U.push(...ru(a,l,s,r,L,E,e)),D.gaps=U=o.gaps(t,n,s,r,U),D.clip=Da(U,c.ori,m,_,v,p)}return V!=0&&(D.band=V==2?[Oi(t,n,s,r,N,-1),Oi(t,n,s,r,N,1)]:Oi(t,n,s,r,N,V)),D})}function Bg(i){const e=vt(i.align,1),t=vt(i.ascDesc,!1),n=vt(i.alignGaps,0),s=vt(i.extend,!1);return(r,o,a,l)=>ks(r,o,(c,u,h,d,m,_,v,p,f,E,T)=>{[a,l]=Ra(h,a,l);let M=c.pxRound,{left:k,width:L}=r.bbox,D=he=>M(_(he,d,E,p)),N=he=>M(v(he,m,T,f)),w=d.ori==0?Nr:Ir;const y={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:yr},R=y.stroke,V=d.dir*(d.ori==0?1:-1);let U=N(h[V==1?a:l]),K=D(u[V==1?a:l]),X=K,Q=K;s&&e==-1&&(Q=k,w(R,Q,U)),w(R,K,U);for(let he=V==1?a:l;he>=a&&he<=l;he+=V){let _e=h[he];if(_e==null)continue;let ye=D(u[he]),ge=N(_e);e==1?w(R,ye,U):w(R,X,ge),w(R,ye,ge),U=ge,X=ye}let J=X;s&&e==1&&(J=k+L,w(R,J,U));let[ne,fe]=su(r,o);if(c.fill!=null||ne!=0){let he=y.fill=new Path2D(R),_e=c.fillTo(r,o,c.min,c.max,ne),ye=N(_e);w(he,J,ye),w(he,Q,ye)}if(!c.spanGaps){let he=[];he.push(...ru(u,h,a,l,V,D,n));let _e=c.width*yt/2,ye=t||e==1?_e:-_e,ge=t||e==-1?-_e:_e;he.forEach(re=>{re[0]+=ye,re[1]+=ge}),y.gaps=he=c.gaps(r,o,a,l,he),y.clip=Da(he,d.ori,p,f,E,T)}return fe!=0&&(y.band=fe==2?[Oi(r,o,a,l,R,-1),Oi(r,o,a,l,R,1)]:Oi(r,o,a,l,R,fe)),y})}function Ch(i,e,t,n,s,r,o=Ct){if(i.length>1){let a=null;for(let l=0,c=1/0;l<i.length;l++)if(e[l]!==void 0){if(a!=null){let u=Zt(i[l]-i[a]);u<c&&(c=u,o=Zt(t(i[l],n,s,r)-t(i[a],n,s,r)))}a=l}}return o}function zg(i){i=i||co;const e=vt(i.size,[.6,Ct,1]),t=i.align||0,n=i.gap||0;let s=i.radius;s=s==null?[0,0]:typeof s=="number"?[s,0]:s;const r=ot(s),o=1-e[0],a=vt(e[1],Ct),l=vt(e[2],1),c=vt(i.disp,co),u=vt(i.each,m=>{}),{fill:h,stroke:d}=c;return(m,_,v,p)=>ks(m,_,(f,E,T,M,k,L,D,N,w,y,R)=>{let V=f.pxRound,U=t,K=n*yt,X=a*yt,Q=l*yt,J,ne;M.ori==0?[J,ne]=r(m,_):[ne,J]=r(m,_);const fe=M.dir*(M.ori==0?1:-1);let he=M.ori==0?Ua:ou,_e=M.ori==0?u:(G,ie,be,xe,Ae,Ke,pe)=>{u(G,ie,be,Ae,xe,pe,Ke)},ye=vt(m.bands,Qc).find(G=>G.series[0]==_),ge=ye!=null?ye.dir:0,re=f.fillTo(m,_,f.min,f.max,ge),ce=V(D(re,k,R,w)),ve,le,He,Ge=y,Fe=V(f.width*yt),lt=!1,Ze=null,ct=null,z=null,Yt=null;h!=null&&(Fe==0||d!=null)&&(lt=!0,Ze=h.values(m,_,v,p),ct=new Map,new Set(Ze).forEach(G=>{G!=null&&ct.set(G,new Path2D)}),Fe>0&&(z=d.values(m,_,v,p),Yt=new Map,new Set(z).forEach(G=>{G!=null&&Yt.set(G,new Path2D)})));let{x0:Qe,size:tt}=c;if(Qe!=null&&tt!=null){U=1,E=Qe.values(m,_,v,p),Qe.unit==2&&(E=E.map(be=>m.posToVal(N+be*y,M.key,!0)));let G=tt.values(m,_,v,p);tt.unit==2?le=G[0]*y:le=L(G[0],M,y,N)-L(0,M,y,N),Ge=Ch(E,T,L,M,y,N,Ge),He=Ge-le+K}else Ge=Ch(E,T,L,M,y,N,Ge),He=Ge*o+K,le=Ge-He;He<1&&(He=0),Fe>=le/2&&(Fe=0),He<5&&(V=rf);let We=He>0,ht=Ge-He-(We?Fe:0);le=V(jl(ht,Q,X)),ve=(U==0?le/2:U==fe?0:le)-U*fe*((U==0?K/2:0)+(We?Fe/2:0));const De={stroke:null,fill:null,clip:null,band:null,gaps:null,flags:0},C=lt?null:new Path2D;let S=null;if(ye!=null)S=m.data[ye.series[1]];else{let{y0:G,y1:ie}=c;G!=null&&ie!=null&&(T=ie.values(m,_,v,p),S=G.values(m,_,v,p))}let Z=J*le,ee=ne*le;for(let G=fe==1?v:p;G>=v&&G<=p;G+=fe){let ie=T[G];if(ie==null)continue;if(S!=null){let Be=S[G]??0;if(ie-Be==0)continue;ce=D(Be,k,R,w)}let be=M.distr!=2||c!=null?E[G]:G,xe=L(be,M,y,N),Ae=D(vt(ie,re),k,R,w),Ke=V(xe-ve),pe=V(Sn(Ae,ce)),Me=V(ni(Ae,ce)),Oe=pe-Me;if(ie!=null){let Be=ie<0?ee:Z,we=ie<0?Z:ee;lt?(Fe>0&&z[G]!=null&&he(Yt.get(z[G]),Ke,Me+On(Fe/2),le,Sn(0,Oe-Fe),Be,we),Ze[G]!=null&&he(ct.get(Ze[G]),Ke,Me+On(Fe/2),le,Sn(0,Oe-Fe),Be,we)):he(C,Ke,Me+On(Fe/2),le,Sn(0,Oe-Fe),Be,we),_e(m,_,G,Ke-Fe/2,Me,le+Fe,Oe)}}return Fe>0?De.stroke=lt?Yt:C:lt||(De._fill=f.width==0?f._fill:f._stroke??f._fill,De.width=0),De.fill=lt?ct:C,De})}function Hg(i,e){const t=vt(e?.alignGaps,0);return(n,s,r,o)=>ks(n,s,(a,l,c,u,h,d,m,_,v,p,f)=>{[r,o]=Ra(c,r,o);let E=a.pxRound,T=J=>E(d(J,u,p,_)),M=J=>E(m(J,h,f,v)),k,L,D;u.ori==0?(k=Na,D=Nr,L=Df):(k=Ia,D=Ir,L=Nf);const N=u.dir*(u.ori==0?1:-1);let w=T(l[N==1?r:o]),y=w,R=[],V=[];for(let J=N==1?r:o;J>=r&&J<=o;J+=N)if(c[J]!=null){let fe=l[J],he=T(fe);R.push(y=he),V.push(M(c[J]))}const U={stroke:i(R,V,k,D,L,E),fill:null,clip:null,band:null,gaps:null,flags:yr},K=U.stroke;let[X,Q]=su(n,s);if(a.fill!=null||X!=0){let J=U.fill=new Path2D(K),ne=a.fillTo(n,s,a.min,a.max,X),fe=M(ne);D(J,y,fe),D(J,w,fe)}if(!a.spanGaps){let J=[];J.push(...ru(l,c,r,o,N,T,t)),U.gaps=J=a.gaps(n,s,r,o,J),U.clip=Da(J,u.ori,_,v,p,f)}return Q!=0&&(U.band=Q==2?[Oi(n,s,r,o,K,-1),Oi(n,s,r,o,K,1)]:Oi(n,s,r,o,K,Q)),U})}function Vg(i){return Hg(Gg,i)}function Gg(i,e,t,n,s,r){const o=i.length;if(o<2)return null;const a=new Path2D;if(t(a,i[0],e[0]),o==2)n(a,i[1],e[1]);else{let l=Array(o),c=Array(o-1),u=Array(o-1),h=Array(o-1);for(let d=0;d<o-1;d++)u[d]=e[d+1]-e[d],h[d]=i[d+1]-i[d],c[d]=u[d]/h[d];l[0]=c[0];for(let d=1;d<o-1;d++)c[d]===0||c[d-1]===0||c[d-1]>0!=c[d]>0?l[d]=0:(l[d]=3*(h[d-1]+h[d])/((2*h[d]+h[d-1])/c[d-1]+(h[d]+2*h[d-1])/c[d]),isFinite(l[d])||(l[d]=0));l[o-1]=c[o-2];for(let d=0;d<o-1;d++)s(a,i[d]+h[d]/3,e[d]+l[d]*h[d]/3,i[d+1]-h[d]/3,e[d+1]-l[d+1]*h[d]/3,i[d+1],e[d+1])}return a}const Ql=new Set;function Ph(){for(let i of Ql)i.syncRect(!0)}Dr&&(Cs(bm,mr,Ph),Cs(Em,mr,Ph,!0),Cs(ma,mr,()=>{mn.pxRatio=yt}));const Wg=Ff(),$g=If();function Lh(i,e,t,n){return(n?[i[0],i[1]].concat(i.slice(2)):[i[0]].concat(i.slice(1))).map((r,o)=>ec(r,o,e,t))}function Xg(i,e){return i.map((t,n)=>n==0?{}:qt({},e,t))}function ec(i,e,t,n){return qt({},e==0?t:n,i)}function Of(i,e,t){return e==null?Mr:[e,t]}const qg=Of;function Yg(i,e,t){return e==null?Mr:ga(e,t,Zc,!0)}function kf(i,e,t,n){return e==null?Mr:Ca(e,t,i.scales[n].log,!1)}const jg=kf;function Bf(i,e,t,n){return e==null?Mr:Kc(e,t,i.scales[n].log,!1)}const Kg=Bf;function Zg(i,e,t,n,s){let r=Sn(ch(i),ch(e)),o=e-i,a=ti(s/n*o,t);do{let l=t[a],c=n*l/o;if(c>=s&&r+(l<5?ss.get(l):0)<=17)return[l,c]}while(++a<t.length);return[0,0]}function Dh(i){let e,t;return i=i.replace(/(\d+)px/,(n,s)=>(e=Kt((t=+s)*yt))+"px"),[i,e,t]}function Jg(i){i.show&&[i.font,i.labelFont].forEach(e=>{let t=Pt(e[2]*yt,1);e[0]=e[0].replace(/[0-9.]+px/,t+"px"),e[1]=t})}function mn(i,e,t){const n={mode:vt(i.mode,1)},s=n.mode;function r(g,x,A,P){let I=x.valToPct(g);return P+A*(x.dir==-1?1-I:I)}function o(g,x,A,P){let I=x.valToPct(g);return P+A*(x.dir==-1?I:1-I)}function a(g,x,A,P){return x.ori==0?r(g,x,A,P):o(g,x,A,P)}n.valToPosH=r,n.valToPosV=o;let l=!1;n.status=0;const c=n.root=Gn(rm);if(i.id!=null&&(c.id=i.id),In(c,i.class),i.title){let g=Gn(lm,c);g.textContent=i.title}const u=ei("canvas"),h=n.ctx=u.getContext("2d"),d=Gn(cm,c);Cs("click",d,g=>{g.target===_&&(Dt!=Xs||kt!=qs)&&cn.click(n,g)},!0);const m=n.under=Gn(um,d);d.appendChild(u);const _=n.over=Gn(hm,d);i=Sr(i);const v=+vt(i.pxAlign,1),p=Rh(v);(i.plugins||[]).forEach(g=>{g.opts&&(i=g.opts(n,i)||i)});const f=i.ms||.001,E=n.series=s==1?Lh(i.series||[],Sh,Th,!1):Xg(i.series||[null],wh),T=n.axes=Lh(i.axes||[],Mh,bh,!0),M=n.scales={},k=n.bands=i.bands||[];k.forEach(g=>{g.fill=ot(g.fill||null),g.dir=vt(g.dir,-1)});const L=s==2?E[1].facets[0].scale:E[0].scale,D={axes:Wp,series:Bn},N=(i.drawOrder||["axes","series"]).map(g=>D[g]);function w(g){const x=g.distr==3?A=>Fi(A>0?A:g.clamp(n,A,g.min,g.max,g.key)):g.distr==4?A=>il(A,g.asinh):g.distr==100?A=>g.fwd(A):A=>A;return A=>{let P=x(A),{_min:I,_max:j}=g,oe=j-I;return(P-I)/oe}}function y(g){let x=M[g];if(x==null){let A=(i.scales||co)[g]||co;if(A.from!=null){y(A.from);let P=qt({},M[A.from],A,{key:g});P.valToPct=w(P),M[g]=P}else{x=M[g]=qt({},g==L?Af:Ig,A),x.key=g;let P=x.time,I=x.range,j=Ji(I);if((g!=L||s==2&&!P)&&(j&&(I[0]==null||I[1]==null)&&(I={min:I[0]==null?oh:{mode:1,hard:I[0],soft:I[0]},max:I[1]==null?oh:{mode:1,hard:I[1],soft:I[1]}},j=!1),!j&&La(I))){let oe=I;I=(ue,me,Pe)=>me==null?Mr:ga(me,Pe,oe)}x.range=ot(I||(P?qg:g==L?x.distr==3?jg:x.distr==4?Kg:Of:x.distr==3?kf:x.distr==4?Bf:Yg)),x.auto=ot(j?!1:x.auto),x.clamp=ot(x.clamp||Ng),x._min=x._max=null,x.valToPct=w(x)}}}y("x"),y("y"),s==1&&E.forEach(g=>{y(g.scale)}),T.forEach(g=>{y(g.scale)});for(let g in i.scales)y(g);const R=M[L],V=R.distr;let U,K;R.ori==0?(In(c,om),U=r,K=o):(In(c,am),U=o,K=r);const X={};for(let g in M){let x=M[g];(x.min!=null||x.max!=null)&&(X[g]={min:x.min,max:x.max},x.min=x.max=null)}const Q=i.tzDate||(g=>new Date(Kt(g/f))),J=i.fmtDate||eu,ne=f==1?og(Q):cg(Q),fe=_h(Q,gh(f==1?rg:lg,J)),he=xh(Q,vh(hg,J)),_e=[],ye=n.legend=qt({},pg,i.legend),ge=n.cursor=qt({},Mg,{drag:{y:s==2}},i.cursor),re=ye.show,ce=ge.show,ve=ye.markers;ye.idxs=_e,ve.width=ot(ve.width),ve.dash=ot(ve.dash),ve.stroke=ot(ve.stroke),ve.fill=ot(ve.fill);let le,He,Ge,Fe=[],lt=[],Ze,ct=!1,z={};if(ye.live){const g=E[1]?E[1].values:null;ct=g!=null,Ze=ct?g(n,1,0):{_:0};for(let x in Ze)z[x]=Yc}if(re)if(le=ei("table",_m,c),Ge=ei("tbody",null,le),ye.mount(n,le),ct){He=ei("thead",null,le,Ge);let g=ei("tr",null,He);ei("th",null,g);for(var Yt in Ze)ei("th",qu,g).textContent=Yt}else In(le,xm),ye.live&&In(le,vm);const Qe={show:!0},tt={show:!1};function We(g,x){if(x==0&&(ct||!ye.live||s==2))return Mr;let A=[],P=ei("tr",Mm,Ge,Ge.childNodes[x]);In(P,g.class),g.show||In(P,bs);let I=ei("th",null,P);if(ve.show){let ue=Gn(Sm,I);if(x>0){let me=ve.width(n,x);me&&(ue.style.border=me+"px "+ve.dash(n,x)+" "+ve.stroke(n,x)),ue.style.background=ve.fill(n,x)}}let j=Gn(qu,I);g.label instanceof HTMLElement?j.appendChild(g.label):j.textContent=g.label,x>0&&(ve.show||(j.style.color=g.width>0?ve.stroke(n,x):ve.fill(n,x)),De("click",I,ue=>{if(ge._lock)return;jt(ue);let me=E.indexOf(g);if((ue.ctrlKey||ue.metaKey)!=ye.isolate){let Pe=E.some((Le,Ne)=>Ne>0&&Ne!=me&&Le.show);E.forEach((Le,Ne)=>{Ne>0&&hi(Ne,Pe?Ne==me?Qe:tt:Qe,!0,Wt.setSeries)})}else hi(me,{show:!g.show},!0,Wt.setSeries)},!1),bi&&De(Zu,I,ue=>{ge._lock||(jt(ue),hi(E.indexOf(g),js,!0,Wt.setSeries))},!1));for(var oe in Ze){let ue=ei("td",ym,P);ue.textContent="--",A.push(ue)}return[P,A]}const ht=new Map;function De(g,x,A,P=!0){const I=ht.get(x)||{},j=ge.bind[g](n,x,A,P);j&&(Cs(g,x,I[g]=j),ht.set(x,I))}function C(g,x,A){const P=ht.get(x)||{};for(let I in P)(g==null||I==g)&&(Yl(I,x,P[I]),delete P[I]);g==null&&ht.delete(x)}let S=0,Z=0,ee=0,G=0,ie=0,be=0,xe=ie,Ae=be,Ke=ee,pe=G,Me=0,Oe=0,Be=0,we=0;n.bbox={};let it=!1,Ye=!1,dt=!1,O=!1,Se=!1,se=!1;function ae(g,x,A){(A||g!=n.width||x!=n.height)&&Re(g,x),Vs(!1),dt=!0,Ye=!0,Gs()}function Re(g,x){n.width=S=ee=g,n.height=Z=G=x,ie=be=0,tn(),Mt();let A=n.bbox;Me=A.left=Ms(ie*yt,.5),Oe=A.top=Ms(be*yt,.5),Be=A.width=Ms(ee*yt,.5),we=A.height=Ms(G*yt,.5)}const Ce=3;function Je(){let g=!1,x=0;for(;!g;){x++;let A=Vp(x),P=Gp(x);g=x==Ce||A&&P,g||(Re(n.width,n.height),Ye=!0)}}function Ft({width:g,height:x}){ae(g,x)}n.setSize=Ft;function tn(){let g=!1,x=!1,A=!1,P=!1;T.forEach((I,j)=>{if(I.show&&I._show){let{side:oe,_size:ue}=I,me=oe%2,Pe=I.label!=null?I.labelSize:0,Le=ue+Pe;Le>0&&(me?(ee-=Le,oe==3?(ie+=Le,P=!0):A=!0):(G-=Le,oe==0?(be+=Le,g=!0):x=!0))}}),li[0]=g,li[1]=A,li[2]=x,li[3]=P,ee-=b[1]+b[3],ie+=b[3],G-=b[2]+b[0],be+=b[0]}function Mt(){let g=ie+ee,x=be+G,A=ie,P=be;function I(j,oe){switch(j){case 1:return g+=oe,g-oe;case 2:return x+=oe,x-oe;case 3:return A-=oe,A+oe;case 0:return P-=oe,P+oe}}T.forEach((j,oe)=>{if(j.show&&j._show){let ue=j.side;j._pos=I(ue,j._size),j.label!=null&&(j._lpos=I(ue,j.labelSize))}})}if(ge.dataIdx==null){let g=ge.hover,x=g.skip=new Set(g.skip??[]);x.add(void 0);let A=g.prox=ot(g.prox),P=g.bias??=0;ge.dataIdx=(I,j,oe,ue)=>{if(j==0)return oe;let me=oe,Pe=A(I,j,oe,ue)??Ct,Le=Pe>=0&&Pe<Ct,Ne=R.ori==0?ee:G,je=ge.left,St=e[0],gt=e[j];if(x.has(gt[oe])){me=null;let st=null,Xe=null,Ve;if(P==0||P==-1)for(Ve=oe;st==null&&Ve-- >0;)x.has(gt[Ve])||(st=Ve);if(P==0||P==1)for(Ve=oe;Xe==null&&Ve++<gt.length;)x.has(gt[Ve])||(Xe=Ve);if(st!=null||Xe!=null)if(Le){let It=st==null?-1/0:U(St[st],R,Ne,0),Ht=Xe==null?1/0:U(St[Xe],R,Ne,0),an=je-It,Tt=Ht-je;an<=Tt?an<=Pe&&(me=st):Tt<=Pe&&(me=Xe)}else me=Xe==null?st:st==null?Xe:oe-st<=Xe-oe?st:Xe}else Le&&Zt(je-U(St[oe],R,Ne,0))>Pe&&(me=null);return me}}const jt=g=>{ge.event=g};ge.idxs=_e,ge._lock=!1;let Lt=ge.points;Lt.show=ot(Lt.show),Lt.size=ot(Lt.size),Lt.stroke=ot(Lt.stroke),Lt.width=ot(Lt.width),Lt.fill=ot(Lt.fill);const Rn=n.focus=qt({},i.focus||{alpha:.3},ge.focus),bi=Rn.prox>=0,bn=bi&&Lt.one;let un=[],Ei=[],wi=[];function as(g,x){let A=Lt.show(n,x);if(A instanceof HTMLElement)return In(A,gm),In(A,g.class),mi(A,-10,-10,ee,G),_.insertBefore(A,un[x]),A}function zr(g,x){if(s==1||x>0){let A=s==1&&M[g.scale].time,P=g.value;g.value=A?dh(P)?xh(Q,vh(P,J)):P||he:P||Pg,g.label=g.label||(A?yg:Sg)}if(bn||x>0){g.width=g.width==null?1:g.width,g.paths=g.paths||Wg||Im,g.fillTo=ot(g.fillTo||Ug),g.pxAlign=+vt(g.pxAlign,v),g.pxRound=Rh(g.pxAlign),g.stroke=ot(g.stroke||null),g.fill=ot(g.fill||null),g._stroke=g._fill=g._paths=g._focus=null;let A=Lg(Sn(1,g.width),1),P=g.points=qt({},{size:A,width:Sn(1,A*.2),stroke:g.stroke,space:A*2,paths:$g,_stroke:null,_fill:null},g.points);P.show=ot(P.show),P.filter=ot(P.filter),P.fill=ot(P.fill),P.stroke=ot(P.stroke),P.paths=ot(P.paths),P.pxAlign=g.pxAlign}if(re){let A=We(g,x);Fe.splice(x,0,A[0]),lt.splice(x,0,A[1]),ye.values.push(null)}if(ce){_e.splice(x,0,null);let A=null;bn?x==0&&(A=as(g,x)):x>0&&(A=as(g,x)),un.splice(x,0,A),Ei.splice(x,0,0),wi.splice(x,0,0)}on("addSeries",x)}function zs(g,x){x=x??E.length,g=s==1?ec(g,x,Sh,Th):ec(g,x,{},wh),E.splice(x,0,g),zr(E[x],x)}n.addSeries=zs;function bo(g){if(E.splice(g,1),re){ye.values.splice(g,1),lt.splice(g,1);let x=Fe.splice(g,1)[0];C(null,x.firstChild),x.remove()}ce&&(_e.splice(g,1),un.splice(g,1)[0].remove(),Ei.splice(g,1),wi.splice(g,1)),on("delSeries",g)}n.delSeries=bo;const li=[!1,!1,!1,!1];function Va(g,x){if(g._show=g.show,g.show){let A=g.side%2,P=M[g.scale];P==null&&(g.scale=A?E[1].scale:L,P=M[g.scale]);let I=P.time;g.size=ot(g.size),g.space=ot(g.space),g.rotate=ot(g.rotate),Ji(g.incrs)&&g.incrs.forEach(oe=>{!ss.has(oe)&&ss.set(oe,lf(oe))}),g.incrs=ot(g.incrs||(P.distr==2?ng:I?f==1?sg:ag:Ss)),g.splits=ot(g.splits||(I&&P.distr==1?ne:P.distr==3?Kl:P.distr==4?wg:Eg)),g.stroke=ot(g.stroke),g.grid.stroke=ot(g.grid.stroke),g.ticks.stroke=ot(g.ticks.stroke),g.border.stroke=ot(g.border.stroke);let j=g.values;g.values=Ji(j)&&!Ji(j[0])?ot(j):I?Ji(j)?_h(Q,gh(j,J)):dh(j)?ug(Q,j):j||fe:j||bg,g.filter=ot(g.filter||(P.distr>=3&&P.log==10?Rg:P.distr==3&&P.log==2?Cg:of)),g.font=Dh(g.font),g.labelFont=Dh(g.labelFont),g._size=g.size(n,null,x,0),g._space=g._rotate=g._incrs=g._found=g._splits=g._values=null,g._size>0&&(li[x]=!0,g._el=Gn(dm,d))}}function ls(g,x,A,P){let[I,j,oe,ue]=A,me=x%2,Pe=0;return me==0&&(ue||j)&&(Pe=x==0&&!I||x==2&&!oe?Kt(Mh.size/3):0),me==1&&(I||oe)&&(Pe=x==1&&!j||x==3&&!ue?Kt(bh.size/2):0),Pe}const Eo=n.padding=(i.padding||[ls,ls,ls,ls]).map(g=>ot(vt(g,ls))),b=n._padding=Eo.map((g,x)=>g(n,x,li,0));let F,$=null,q=null;const H=s==1?E[0].idxs:null;let de=null,Ee=!1;function ke(g,x){if(e=g??[],n.data=n._data=e,s==2){F=0;for(let A=1;A<E.length;A++)F+=e[A][0].length}else{e.length==0&&(n.data=n._data=e=[[]]),de=e[0],F=de.length;let A=e;if(V==2){A=e.slice();let P=A[0]=Array(F);for(let I=0;I<F;I++)P[I]=I}n._data=e=A}if(Vs(!0),on("setData"),V==2&&(dt=!0),x!==!1){let A=R;A.auto(n,Ee)?Ie():Vi(L,A.min,A.max),O=O||ge.left>=0,se=!0,Gs()}}n.setData=ke;function Ie(){Ee=!0;let g,x;s==1&&(F>0?($=H[0]=0,q=H[1]=F-1,g=e[0][$],x=e[0][q],V==2?(g=$,x=q):g==x&&(V==3?[g,x]=Ca(g,g,R.log,!1):V==4?[g,x]=Kc(g,g,R.log,!1):R.time?x=g+Kt(86400/f):[g,x]=ga(g,x,Zc,!0))):($=H[0]=g=null,q=H[1]=x=null)),Vi(L,g,x)}let $e,qe,Ue,rt,bt,wt,nn,ut,ze,Ot;function ft(g,x,A,P,I,j){g??=ju,A??=Qc,P??="butt",I??=ju,j??="round",g!=$e&&(h.strokeStyle=$e=g),I!=qe&&(h.fillStyle=qe=I),x!=Ue&&(h.lineWidth=Ue=x),j!=bt&&(h.lineJoin=bt=j),P!=wt&&(h.lineCap=wt=P),A!=rt&&h.setLineDash(rt=A)}function En(g,x,A,P){x!=qe&&(h.fillStyle=qe=x),g!=nn&&(h.font=nn=g),A!=ut&&(h.textAlign=ut=A),P!=ze&&(h.textBaseline=ze=P)}function ci(g,x,A,P,I=0){if(P.length>0&&g.auto(n,Ee)&&(x==null||x.min==null)){let j=vt($,0),oe=vt(q,P.length-1),ue=A.min==null?Rm(P,j,oe,I,g.distr==3):[A.min,A.max];g.min=ni(g.min,A.min=ue[0]),g.max=Sn(g.max,A.max=ue[1])}}const hn={min:null,max:null};function cs(){for(let P in M){let I=M[P];X[P]==null&&(I.min==null||X[L]!=null&&I.auto(n,Ee))&&(X[P]=hn)}for(let P in M){let I=M[P];X[P]==null&&I.from!=null&&X[I.from]!=null&&(X[P]=hn)}X[L]!=null&&Vs(!0);let g={};for(let P in X){let I=X[P];if(I!=null){let j=g[P]=Sr(M[P],Om);if(I.min!=null)qt(j,I);else if(P!=L||s==2)if(F==0&&j.from==null){let oe=j.range(n,null,null,P);j.min=oe[0],j.max=oe[1]}else j.min=Ct,j.max=-Ct}}if(F>0){E.forEach((P,I)=>{if(s==1){let j=P.scale,oe=X[j];if(oe==null)return;let ue=g[j];if(I==0){let me=ue.range(n,ue.min,ue.max,j);ue.min=me[0],ue.max=me[1],$=ti(ue.min,e[0]),q=ti(ue.max,e[0]),q-$>1&&(e[0][$]<ue.min&&$++,e[0][q]>ue.max&&q--),P.min=de[$],P.max=de[q]}else P.show&&P.auto&&ci(ue,oe,P,e[I],P.sorted);P.idxs[0]=$,P.idxs[1]=q}else if(I>0&&P.show&&P.auto){let[j,oe]=P.facets,ue=j.scale,me=oe.scale,[Pe,Le]=e[I],Ne=g[ue],je=g[me];Ne!=null&&ci(Ne,X[ue],j,Pe,j.sorted),je!=null&&ci(je,X[me],oe,Le,oe.sorted),P.min=oe.min,P.max=oe.max}});for(let P in g){let I=g[P],j=X[P];if(I.from==null&&(j==null||j.min==null)){let oe=I.range(n,I.min==Ct?null:I.min,I.max==-Ct?null:I.max,P);I.min=oe[0],I.max=oe[1]}}}for(let P in g){let I=g[P];if(I.from!=null){let j=g[I.from];if(j.min==null)I.min=I.max=null;else{let oe=I.range(n,j.min,j.max,P);I.min=oe[0],I.max=oe[1]}}}let x={},A=!1;for(let P in g){let I=g[P],j=M[P];if(j.min!=I.min||j.max!=I.max){j.min=I.min,j.max=I.max;let oe=j.distr;j._min=oe==3?Fi(j.min):oe==4?il(j.min,j.asinh):oe==100?j.fwd(j.min):j.min,j._max=oe==3?Fi(j.max):oe==4?il(j.max,j.asinh):oe==100?j.fwd(j.max):j.max,x[P]=A=!0}}if(A){E.forEach((P,I)=>{s==2?I>0&&x.y&&(P._paths=null):x[P.scale]&&(P._paths=null)});for(let P in x)dt=!0,on("setScale",P);ce&&ge.left>=0&&(O=se=!0)}for(let P in X)X[P]=null}function Rt(g){let x=jl($-1,0,F-1),A=jl(q+1,0,F-1);for(;g[x]==null&&x>0;)x--;for(;g[A]==null&&A<F-1;)A++;return[x,A]}function Bn(){if(F>0){let g=E.some(x=>x._focus)&&Ot!=Rn.alpha;g&&(h.globalAlpha=Ot=Rn.alpha),E.forEach((x,A)=>{if(A>0&&x.show&&(zi(A,!1),zi(A,!0),x._paths==null)){let P=Ot;Ot!=x.alpha&&(h.globalAlpha=Ot=x.alpha);let I=s==2?[0,e[A][0].length-1]:Rt(e[A]);x._paths=x.paths(n,A,I[0],I[1]),Ot!=P&&(h.globalAlpha=Ot=P)}}),E.forEach((x,A)=>{if(A>0&&x.show){let P=Ot;Ot!=x.alpha&&(h.globalAlpha=Ot=x.alpha),x._paths!=null&&gn(A,!1);{let I=x._paths!=null?x._paths.gaps:null,j=x.points.show(n,A,$,q,I),oe=x.points.filter(n,A,j,I);(j||oe)&&(x.points._paths=x.points.paths(n,A,$,q,oe),gn(A,!0))}Ot!=P&&(h.globalAlpha=Ot=P),on("drawSeries",A)}}),g&&(h.globalAlpha=Ot=1)}}function zi(g,x){let A=x?E[g].points:E[g];A._stroke=A.stroke(n,g),A._fill=A.fill(n,g)}function gn(g,x){let A=x?E[g].points:E[g],{stroke:P,fill:I,clip:j,flags:oe,_stroke:ue=A._stroke,_fill:me=A._fill,_width:Pe=A.width}=A._paths;Pe=Pt(Pe*yt,3);let Le=null,Ne=Pe%2/2;x&&me==null&&(me=Pe>0?"#fff":ue);let je=A.pxAlign==1&&Ne>0;if(je&&h.translate(Ne,Ne),!x){let St=Me-Pe/2,gt=Oe-Pe/2,st=Be+Pe,Xe=we+Pe;Le=new Path2D,Le.rect(St,gt,st,Xe)}x?Hs(ue,Pe,A.dash,A.cap,me,P,I,oe,j):ui(g,ue,Pe,A.dash,A.cap,me,P,I,oe,Le,j),je&&h.translate(-Ne,-Ne)}function ui(g,x,A,P,I,j,oe,ue,me,Pe,Le){let Ne=!1;me!=0&&k.forEach((je,St)=>{if(je.series[0]==g){let gt=E[je.series[1]],st=e[je.series[1]],Xe=(gt._paths||co).band;Ji(Xe)&&(Xe=je.dir==1?Xe[0]:Xe[1]);let Ve,It=null;gt.show&&Xe&&Pm(st,$,q)?(It=je.fill(n,St)||j,Ve=gt._paths.clip):Xe=null,Hs(x,A,P,I,It,oe,ue,me,Pe,Le,Ve,Xe),Ne=!0}}),Ne||Hs(x,A,P,I,j,oe,ue,me,Pe,Le)}const Yn=yr|Jl;function Hs(g,x,A,P,I,j,oe,ue,me,Pe,Le,Ne){ft(g,x,A,P,I),(me||Pe||Ne)&&(h.save(),me&&h.clip(me),Pe&&h.clip(Pe)),Ne?(ue&Yn)==Yn?(h.clip(Ne),Le&&h.clip(Le),To(I,oe),wo(g,j,x)):ue&Jl?(To(I,oe),h.clip(Ne),wo(g,j,x)):ue&yr&&(h.save(),h.clip(Ne),Le&&h.clip(Le),To(I,oe),h.restore(),wo(g,j,x)):(To(I,oe),wo(g,j,x)),(me||Pe||Ne)&&h.restore()}function wo(g,x,A){A>0&&(x instanceof Map?x.forEach((P,I)=>{h.strokeStyle=$e=I,h.stroke(P)}):x!=null&&g&&h.stroke(x))}function To(g,x){x instanceof Map?x.forEach((A,P)=>{h.fillStyle=qe=P,h.fill(A)}):x!=null&&g&&h.fill(x)}function Hp(g,x,A,P){let I=T[g],j;if(P<=0)j=[0,0];else{let oe=I._space=I.space(n,g,x,A,P),ue=I._incrs=I.incrs(n,g,x,A,P,oe);j=Zg(x,A,ue,P,oe)}return I._found=j}function Ga(g,x,A,P,I,j,oe,ue,me,Pe){let Le=oe%2/2;v==1&&h.translate(Le,Le),ft(ue,oe,me,Pe,ue),h.beginPath();let Ne,je,St,gt,st=I+(P==0||P==3?-j:j);A==0?(je=I,gt=st):(Ne=I,St=st);for(let Xe=0;Xe<g.length;Xe++)x[Xe]!=null&&(A==0?Ne=St=g[Xe]:je=gt=g[Xe],h.moveTo(Ne,je),h.lineTo(St,gt));h.stroke(),v==1&&h.translate(-Le,-Le)}function Vp(g){let x=!0;return T.forEach((A,P)=>{if(!A.show)return;let I=M[A.scale];if(I.min==null){A._show&&(x=!1,A._show=!1,Vs(!1));return}else A._show||(x=!1,A._show=!0,Vs(!1));let j=A.side,oe=j%2,{min:ue,max:me}=I,[Pe,Le]=Hp(P,ue,me,oe==0?ee:G);if(Le==0)return;let Ne=I.distr==2,je=A._splits=A.splits(n,P,ue,me,Pe,Le,Ne),St=I.distr==2?je.map(Ve=>de[Ve]):je,gt=I.distr==2?de[je[1]]-de[je[0]]:Pe,st=A._values=A.values(n,A.filter(n,St,P,Le,gt),P,Le,gt);A._rotate=j==2?A.rotate(n,st,P,Le):0;let Xe=A._size;A._size=$n(A.size(n,st,P,g)),Xe!=null&&A._size!=Xe&&(x=!1)}),x}function Gp(g){let x=!0;return Eo.forEach((A,P)=>{let I=A(n,P,li,g);I!=b[P]&&(x=!1),b[P]=I}),x}function Wp(){for(let g=0;g<T.length;g++){let x=T[g];if(!x.show||!x._show)continue;let A=x.side,P=A%2,I,j,oe=x.stroke(n,g),ue=A==0||A==3?-1:1,[me,Pe]=x._found;if(x.label!=null){let vn=x.labelGap*ue,Ln=Kt((x._lpos+vn)*yt);En(x.labelFont[0],oe,"center",A==2?"top":Yu),h.save(),P==1?(I=j=0,h.translate(Ln,Kt(Oe+we/2)),h.rotate((A==3?-la:la)/2)):(I=Kt(Me+Be/2),j=Ln);let ds=sf(x.label)?x.label(n,g,me,Pe):x.label;h.fillText(ds,I,j),h.restore()}if(Pe==0)continue;let Le=M[x.scale],Ne=P==0?Be:we,je=P==0?Me:Oe,St=x._splits,gt=Le.distr==2?St.map(vn=>de[vn]):St,st=Le.distr==2?de[St[1]]-de[St[0]]:me,Xe=x.ticks,Ve=x.border,It=Xe.show?Xe.size:0,Ht=Kt(It*yt),an=Kt((x.alignTo==2?x._size-It-x.gap:x.gap)*yt),Tt=x._rotate*-la/180,Vt=p(x._pos*yt),Cn=(Ht+an)*ue,_n=Vt+Cn;j=P==0?_n:0,I=P==1?_n:0;let zn=x.font[0],jn=x.align==1?Zs:x.align==2?el:Tt>0?Zs:Tt<0?el:P==0?"center":A==3?el:Zs,fi=Tt||P==1?"middle":A==2?"top":Yu;En(zn,oe,jn,fi);let Pn=x.font[1]*x.lineGap,Hn=St.map(vn=>p(a(vn,Le,Ne,je))),Kn=x._values;for(let vn=0;vn<Kn.length;vn++){let Ln=Kn[vn];if(Ln!=null){P==0?I=Hn[vn]:j=Hn[vn],Ln=""+Ln;let ds=Ln.indexOf(`
`)==-1?[Ln]:Ln.split(/\n/gm);for(let xn=0;xn<ds.length;xn++){let Xu=ds[xn];Tt?(h.save(),h.translate(I,j+xn*Pn),h.rotate(Tt),h.fillText(Xu,0,0),h.restore()):h.fillText(Xu,I,j+xn*Pn)}}}Xe.show&&Ga(Hn,Xe.filter(n,gt,g,Pe,st),P,A,Vt,Ht,Pt(Xe.width*yt,3),Xe.stroke(n,g),Xe.dash,Xe.cap);let pi=x.grid;pi.show&&Ga(Hn,pi.filter(n,gt,g,Pe,st),P,P==0?2:1,P==0?Oe:Me,P==0?we:Be,Pt(pi.width*yt,3),pi.stroke(n,g),pi.dash,pi.cap),Ve.show&&Ga([Vt],[1],P==0?1:0,P==0?1:2,P==1?Oe:Me,P==1?we:Be,Pt(Ve.width*yt,3),Ve.stroke(n,g),Ve.dash,Ve.cap)}on("drawAxes")}function Vs(g){E.forEach((x,A)=>{A>0&&(x._paths=null,g&&(s==1?(x.min=null,x.max=null):x.facets.forEach(P=>{P.min=null,P.max=null})))})}let Ao=!1,Wa=!1,Hr=[];function $p(){Wa=!1;for(let g=0;g<Hr.length;g++)on(...Hr[g]);Hr.length=0}function Gs(){Ao||(Wm(Ru),Ao=!0)}function Xp(g,x=!1){Ao=!0,Wa=x,g(n),Ru(),x&&Hr.length>0&&queueMicrotask($p)}n.batch=Xp;function Ru(){if(it&&(cs(),it=!1),dt&&(Je(),dt=!1),Ye){if(Ut(m,Zs,ie),Ut(m,"top",be),Ut(m,no,ee),Ut(m,io,G),Ut(_,Zs,ie),Ut(_,"top",be),Ut(_,no,ee),Ut(_,io,G),Ut(d,no,S),Ut(d,io,Z),u.width=Kt(S*yt),u.height=Kt(Z*yt),T.forEach(({_el:g,_show:x,_size:A,_pos:P,side:I})=>{if(g!=null)if(x){let j=I===3||I===0?A:0,oe=I%2==1;Ut(g,oe?"left":"top",P-j),Ut(g,oe?"width":"height",A),Ut(g,oe?"top":"left",oe?be:ie),Ut(g,oe?"height":"width",oe?G:ee),ql(g,bs)}else In(g,bs)}),$e=qe=Ue=bt=wt=nn=ut=ze=rt=null,Ot=1,Wr(!0),ie!=xe||be!=Ae||ee!=Ke||G!=pe){Vs(!1);let g=ee/Ke,x=G/pe;if(ce&&!O&&ge.left>=0){ge.left*=g,ge.top*=x,Ws&&mi(Ws,Kt(ge.left),0,ee,G),$s&&mi($s,0,Kt(ge.top),ee,G);for(let A=0;A<un.length;A++){let P=un[A];P!=null&&(Ei[A]*=g,wi[A]*=x,mi(P,$n(Ei[A]),$n(wi[A]),ee,G))}}if(Nt.show&&!Se&&Nt.left>=0&&Nt.width>0){Nt.left*=g,Nt.width*=g,Nt.top*=x,Nt.height*=x;for(let A in Ka)Ut(Ys,A,Nt[A])}xe=ie,Ae=be,Ke=ee,pe=G}on("setSize"),Ye=!1}S>0&&Z>0&&(h.clearRect(0,0,u.width,u.height),on("drawClear"),N.forEach(g=>g()),on("draw")),Nt.show&&Se&&(Ro(Nt),Se=!1),ce&&O&&(hs(null,!0,!1),O=!1),ye.show&&ye.live&&se&&(Ya(),se=!1),l||(l=!0,n.status=1,on("ready")),Ee=!1,Ao=!1}n.redraw=(g,x)=>{dt=x||!1,g!==!1?Vi(L,R.min,R.max):Gs()};function $a(g,x){let A=M[g];if(A.from==null){if(F==0){let P=A.range(n,x.min,x.max,g);x.min=P[0],x.max=P[1]}if(x.min>x.max){let P=x.min;x.min=x.max,x.max=P}if(F>1&&x.min!=null&&x.max!=null&&x.max-x.min<1e-16)return;g==L&&A.distr==2&&F>0&&(x.min=ti(x.min,e[0]),x.max=ti(x.max,e[0]),x.min==x.max&&x.max++),X[g]=x,it=!0,Gs()}}n.setScale=$a;let Xa,qa,Ws,$s,Cu,Pu,Xs,qs,Lu,Du,Dt,kt,Hi=!1;const cn=ge.drag;let sn=cn.x,rn=cn.y;ce&&(ge.x&&(Xa=Gn(pm,_)),ge.y&&(qa=Gn(mm,_)),R.ori==0?(Ws=Xa,$s=qa):(Ws=qa,$s=Xa),Dt=ge.left,kt=ge.top);const Nt=n.select=qt({show:!0,over:!0,left:0,width:0,top:0,height:0},i.select),Ys=Nt.show?Gn(fm,Nt.over?_:m):null;function Ro(g,x){if(Nt.show){for(let A in g)Nt[A]=g[A],A in Ka&&Ut(Ys,A,g[A]);x!==!1&&on("setSelect")}}n.setSelect=Ro;function qp(g){if(E[g].show)re&&ql(Fe[g],bs);else if(re&&In(Fe[g],bs),ce){let A=bn?un[0]:un[g];A!=null&&mi(A,-10,-10,ee,G)}}function Vi(g,x,A){$a(g,{min:x,max:A})}function hi(g,x,A,P){x.focus!=null&&Jp(g),x.show!=null&&E.forEach((I,j)=>{j>0&&(g==j||g==null)&&(I.show=x.show,qp(j),s==2?(Vi(I.facets[0].scale,null,null),Vi(I.facets[1].scale,null,null)):Vi(I.scale,null,null),Gs())}),A!==!1&&on("setSeries",g,x),P&&$r("setSeries",n,g,x)}n.setSeries=hi;function Yp(g,x){qt(k[g],x)}function jp(g,x){g.fill=ot(g.fill||null),g.dir=vt(g.dir,-1),x=x??k.length,k.splice(x,0,g)}function Kp(g){g==null?k.length=0:k.splice(g,1)}n.addBand=jp,n.setBand=Yp,n.delBand=Kp;function Zp(g,x){E[g].alpha=x,ce&&un[g]!=null&&(un[g].style.opacity=x),re&&Fe[g]&&(Fe[g].style.opacity=x)}let Ti,Gi,us;const js={focus:!0};function Jp(g){if(g!=us){let x=g==null,A=Rn.alpha!=1;E.forEach((P,I)=>{if(s==1||I>0){let j=x||I==0||I==g;P._focus=x?null:j,A&&Zp(I,j?1:Rn.alpha)}}),us=g,A&&Gs()}}re&&bi&&De(Ju,le,g=>{ge._lock||(jt(g),us!=null&&hi(null,js,!0,Wt.setSeries))});function di(g,x,A){let P=M[x];A&&(g=g/yt-(P.ori==1?be:ie));let I=ee;P.ori==1&&(I=G,g=I-g),P.dir==-1&&(g=I-g);let j=P._min,oe=P._max,ue=g/I,me=j+(oe-j)*ue,Pe=P.distr;return Pe==3?xr(10,me):Pe==4?Dm(me,P.asinh):Pe==100?P.bwd(me):me}function Qp(g,x){let A=di(g,L,x);return ti(A,e[0],$,q)}n.valToIdx=g=>ti(g,e[0]),n.posToIdx=Qp,n.posToVal=di,n.valToPos=(g,x,A)=>M[x].ori==0?r(g,M[x],A?Be:ee,A?Me:0):o(g,M[x],A?we:G,A?Oe:0),n.setCursor=(g,x,A)=>{Dt=g.left,kt=g.top,hs(null,x,A)};function Nu(g,x){Ut(Ys,Zs,Nt.left=g),Ut(Ys,no,Nt.width=x)}function Iu(g,x){Ut(Ys,"top",Nt.top=g),Ut(Ys,io,Nt.height=x)}let Vr=R.ori==0?Nu:Iu,Gr=R.ori==1?Nu:Iu;function em(){if(re&&ye.live)for(let g=s==2?1:0;g<E.length;g++){if(g==0&&ct)continue;let x=ye.values[g],A=0;for(let P in x)lt[g][A++].firstChild.nodeValue=x[P]}}function Ya(g,x){if(g!=null&&(g.idxs?g.idxs.forEach((A,P)=>{_e[P]=A}):Fm(g.idx)||_e.fill(g.idx),ye.idx=_e[0]),re&&ye.live){for(let A=0;A<E.length;A++)(A>0||s==1&&!ct)&&tm(A,_e[A]);em()}se=!1,x!==!1&&on("setLegend")}n.setLegend=Ya;function tm(g,x){let A=E[g],P=g==0&&V==2?de:e[g],I;ct?I=A.values(n,g,x)??z:(I=A.value(n,x==null?null:P[x],g,x),I=I==null?z:{_:I}),ye.values[g]=I}function hs(g,x,A){Lu=Dt,Du=kt,[Dt,kt]=ge.move(n,Dt,kt),ge.left=Dt,ge.top=kt,ce&&(Ws&&mi(Ws,Kt(Dt),0,ee,G),$s&&mi($s,0,Kt(kt),ee,G));let P,I=$>q;Ti=Ct,Gi=null;let j=R.ori==0?ee:G,oe=R.ori==1?ee:G;if(Dt<0||F==0||I){P=ge.idx=null;for(let ue=0;ue<E.length;ue++){let me=un[ue];me!=null&&mi(me,-10,-10,ee,G)}bi&&hi(null,js,!0,g==null&&Wt.setSeries),ye.live&&(_e.fill(P),se=!0)}else{let ue,me,Pe;s==1&&(ue=R.ori==0?Dt:kt,me=di(ue,L),P=ge.idx=ti(me,e[0],$,q),Pe=U(e[0][P],R,j,0));let Le=-10,Ne=-10,je=0,St=0,gt=!0,st="",Xe="";for(let Ve=s==2?1:0;Ve<E.length;Ve++){let It=E[Ve],Ht=_e[Ve],an=Ht==null?null:s==1?e[Ve][Ht]:e[Ve][1][Ht],Tt=ge.dataIdx(n,Ve,P,me),Vt=Tt==null?null:s==1?e[Ve][Tt]:e[Ve][1][Tt];if(se=se||Vt!=an||Tt!=Ht,_e[Ve]=Tt,Ve>0&&It.show){let Cn=Tt==null?-10:Tt==P?Pe:U(s==1?e[0][Tt]:e[Ve][0][Tt],R,j,0),_n=Vt==null?-10:K(Vt,s==1?M[It.scale]:M[It.facets[1].scale],oe,0);if(bi&&Vt!=null){let zn=R.ori==1?Dt:kt,jn=Zt(Rn.dist(n,Ve,Tt,_n,zn));if(jn<Ti){let fi=Rn.bias;if(fi!=0){let Pn=di(zn,It.scale),Hn=Vt>=0?1:-1,Kn=Pn>=0?1:-1;Kn==Hn&&(Kn==1?fi==1?Vt>=Pn:Vt<=Pn:fi==1?Vt<=Pn:Vt>=Pn)&&(Ti=jn,Gi=Ve)}else Ti=jn,Gi=Ve}}if(se||bn){let zn,jn;R.ori==0?(zn=Cn,jn=_n):(zn=_n,jn=Cn);let fi,Pn,Hn,Kn,pi,vn,Ln=!0,ds=Lt.bbox;if(ds!=null){Ln=!1;let xn=ds(n,Ve);Hn=xn.left,Kn=xn.top,fi=xn.width,Pn=xn.height}else Hn=zn,Kn=jn,fi=Pn=Lt.size(n,Ve);if(vn=Lt.fill(n,Ve),pi=Lt.stroke(n,Ve),bn)Ve==Gi&&Ti<=Rn.prox&&(Le=Hn,Ne=Kn,je=fi,St=Pn,gt=Ln,st=vn,Xe=pi);else{let xn=un[Ve];xn!=null&&(Ei[Ve]=Hn,wi[Ve]=Kn,rh(xn,fi,Pn,Ln),ih(xn,vn,pi),mi(xn,$n(Hn),$n(Kn),ee,G))}}}}if(bn){let Ve=Rn.prox,It=us==null?Ti<=Ve:Ti>Ve||Gi!=us;if(se||It){let Ht=un[0];Ht!=null&&(Ei[0]=Le,wi[0]=Ne,rh(Ht,je,St,gt),ih(Ht,st,Xe),mi(Ht,$n(Le),$n(Ne),ee,G))}}}if(Nt.show&&Hi)if(g!=null){let[ue,me]=Wt.scales,[Pe,Le]=Wt.match,[Ne,je]=g.cursor.sync.scales,St=g.cursor.drag;if(sn=St._x,rn=St._y,sn||rn){let{left:gt,top:st,width:Xe,height:Ve}=g.select,It=g.scales[Ne].ori,Ht=g.posToVal,an,Tt,Vt,Cn,_n,zn=ue!=null&&Pe(ue,Ne),jn=me!=null&&Le(me,je);zn&&sn?(It==0?(an=gt,Tt=Xe):(an=st,Tt=Ve),Vt=M[ue],Cn=U(Ht(an,Ne),Vt,j,0),_n=U(Ht(an+Tt,Ne),Vt,j,0),Vr(ni(Cn,_n),Zt(_n-Cn))):Vr(0,j),jn&&rn?(It==1?(an=gt,Tt=Xe):(an=st,Tt=Ve),Vt=M[me],Cn=K(Ht(an,je),Vt,oe,0),_n=K(Ht(an+Tt,je),Vt,oe,0),Gr(ni(Cn,_n),Zt(_n-Cn))):Gr(0,oe)}else Za()}else{let ue=Zt(Lu-Cu),me=Zt(Du-Pu);if(R.ori==1){let je=ue;ue=me,me=je}sn=cn.x&&ue>=cn.dist,rn=cn.y&&me>=cn.dist;let Pe=cn.uni;Pe!=null?sn&&rn&&(sn=ue>=Pe,rn=me>=Pe,!sn&&!rn&&(me>ue?rn=!0:sn=!0)):cn.x&&cn.y&&(sn||rn)&&(sn=rn=!0);let Le,Ne;sn&&(R.ori==0?(Le=Xs,Ne=Dt):(Le=qs,Ne=kt),Vr(ni(Le,Ne),Zt(Ne-Le)),rn||Gr(0,oe)),rn&&(R.ori==1?(Le=Xs,Ne=Dt):(Le=qs,Ne=kt),Gr(ni(Le,Ne),Zt(Ne-Le)),sn||Vr(0,j)),!sn&&!rn&&(Vr(0,0),Gr(0,0))}if(cn._x=sn,cn._y=rn,g==null){if(A){if($u!=null){let[ue,me]=Wt.scales;Wt.values[0]=ue!=null?di(R.ori==0?Dt:kt,ue):null,Wt.values[1]=me!=null?di(R.ori==1?Dt:kt,me):null}$r(tl,n,Dt,kt,ee,G,P)}if(bi){let ue=A&&Wt.setSeries,me=Rn.prox;us==null?Ti<=me&&hi(Gi,js,!0,ue):Ti>me?hi(null,js,!0,ue):Gi!=us&&hi(Gi,js,!0,ue)}}se&&(ye.idx=P,Ya()),x!==!1&&on("setCursor")}let Wi=null;Object.defineProperty(n,"rect",{get(){return Wi==null&&Wr(!1),Wi}});function Wr(g=!1){g?Wi=null:(Wi=_.getBoundingClientRect(),on("syncRect",Wi))}function Uu(g,x,A,P,I,j,oe){ge._lock||Hi&&g!=null&&g.movementX==0&&g.movementY==0||(ja(g,x,A,P,I,j,oe,!1,g!=null),g!=null?hs(null,!0,!0):hs(x,!0,!1))}function ja(g,x,A,P,I,j,oe,ue,me){if(Wi==null&&Wr(!1),jt(g),g!=null)A=g.clientX-Wi.left,P=g.clientY-Wi.top;else{if(A<0||P<0){Dt=-10,kt=-10;return}let[Pe,Le]=Wt.scales,Ne=x.cursor.sync,[je,St]=Ne.values,[gt,st]=Ne.scales,[Xe,Ve]=Wt.match,It=x.axes[0].side%2==1,Ht=R.ori==0?ee:G,an=R.ori==1?ee:G,Tt=It?j:I,Vt=It?I:j,Cn=It?P:A,_n=It?A:P;if(gt!=null?A=Xe(Pe,gt)?a(je,M[Pe],Ht,0):-10:A=Ht*(Cn/Tt),st!=null?P=Ve(Le,st)?a(St,M[Le],an,0):-10:P=an*(_n/Vt),R.ori==1){let zn=A;A=P,P=zn}}me&&(x==null||x.cursor.event.type==tl)&&((A<=1||A>=ee-1)&&(A=Ms(A,ee)),(P<=1||P>=G-1)&&(P=Ms(P,G))),ue?(Cu=A,Pu=P,[Xs,qs]=ge.move(n,A,P)):(Dt=A,kt=P)}const Ka={width:0,height:0,left:0,top:0};function Za(){Ro(Ka,!1)}let Fu,Ou,ku,Bu;function zu(g,x,A,P,I,j,oe){Hi=!0,sn=rn=cn._x=cn._y=!1,ja(g,x,A,P,I,j,oe,!0,!1),g!=null&&(De(nl,$l,Hu,!1),$r(Ku,n,Xs,qs,ee,G,null));let{left:ue,top:me,width:Pe,height:Le}=Nt;Fu=ue,Ou=me,ku=Pe,Bu=Le}function Hu(g,x,A,P,I,j,oe){Hi=cn._x=cn._y=!1,ja(g,x,A,P,I,j,oe,!1,!0);let{left:ue,top:me,width:Pe,height:Le}=Nt,Ne=Pe>0||Le>0,je=Fu!=ue||Ou!=me||ku!=Pe||Bu!=Le;if(Ne&&je&&Ro(Nt),cn.setScale&&Ne&&je){let St=ue,gt=Pe,st=me,Xe=Le;if(R.ori==1&&(St=me,gt=Le,st=ue,Xe=Pe),sn&&Vi(L,di(St,L),di(St+gt,L)),rn)for(let Ve in M){let It=M[Ve];Ve!=L&&It.from==null&&It.min!=Ct&&Vi(Ve,di(st+Xe,Ve),di(st,Ve))}Za()}else ge.lock&&(ge._lock=!ge._lock,hs(x,!0,g!=null));g!=null&&(C(nl,$l),$r(nl,n,Dt,kt,ee,G,null))}function nm(g,x,A,P,I,j,oe){if(ge._lock)return;jt(g);let ue=Hi;if(Hi){let me=!0,Pe=!0,Le=10,Ne,je;R.ori==0?(Ne=sn,je=rn):(Ne=rn,je=sn),Ne&&je&&(me=Dt<=Le||Dt>=ee-Le,Pe=kt<=Le||kt>=G-Le),Ne&&me&&(Dt=Dt<Xs?0:ee),je&&Pe&&(kt=kt<qs?0:G),hs(null,!0,!0),Hi=!1}Dt=-10,kt=-10,_e.fill(null),hs(null,!0,!0),ue&&(Hi=ue)}function Vu(g,x,A,P,I,j,oe){ge._lock||(jt(g),Ie(),Za(),g!=null&&$r(Qu,n,Dt,kt,ee,G,null))}function Gu(){T.forEach(Jg),ae(n.width,n.height,!0)}Cs(ma,mr,Gu);const Ks={};Ks.mousedown=zu,Ks.mousemove=Uu,Ks.mouseup=Hu,Ks.dblclick=Vu,Ks.setSeries=(g,x,A,P)=>{let I=Wt.match[2];A=I(n,x,A),A!=-1&&hi(A,P,!0,!1)},ce&&(De(Ku,_,zu),De(tl,_,Uu),De(Zu,_,g=>{jt(g),Wr(!1)}),De(Ju,_,nm),De(Qu,_,Vu),Ql.add(n),n.syncRect=Wr);const Co=n.hooks=i.hooks||{};function on(g,x,A){Wa?Hr.push([g,x,A]):g in Co&&Co[g].forEach(P=>{P.call(null,n,x,A)})}(i.plugins||[]).forEach(g=>{for(let x in g.hooks)Co[x]=(Co[x]||[]).concat(g.hooks[x])});const Wu=(g,x,A)=>A,Wt=qt({key:null,setSeries:!1,filters:{pub:uh,sub:uh},scales:[L,E[1]?E[1].scale:null],match:[hh,hh,Wu],values:[null,null]},ge.sync);Wt.match.length==2&&Wt.match.push(Wu),ge.sync=Wt;const $u=Wt.key,Ja=Rf($u);function $r(g,x,A,P,I,j,oe){Wt.filters.pub(g,x,A,P,I,j,oe)&&Ja.pub(g,x,A,P,I,j,oe)}Ja.sub(n);function im(g,x,A,P,I,j,oe){Wt.filters.sub(g,x,A,P,I,j,oe)&&Ks[g](null,x,A,P,I,j,oe)}n.pub=im;function sm(){Ja.unsub(n),Ql.delete(n),ht.clear(),Yl(ma,mr,Gu),c.remove(),le?.remove(),on("destroy")}n.destroy=sm;function Qa(){on("init",i,e),ke(e||i.data,!1),X[L]?$a(L,X[L]):Ie(),Se=Nt.show&&(Nt.width>0||Nt.height>0),O=se=!0,ae(i.width,i.height)}return E.forEach(zr),T.forEach(Va),t?t instanceof HTMLElement?(t.appendChild(c),Qa()):t(n,Qa):Qa(),n}mn.assign=qt;mn.fmtNum=Jc;mn.rangeNum=ga;mn.rangeLog=Ca;mn.rangeAsinh=Kc;mn.orient=ks;mn.pxRatio=yt;mn.join=Gm;mn.fmtDate=eu,mn.tzDate=eg;mn.sync=Rf;{mn.addGap=Fg,mn.clipGaps=Da;let i=mn.paths={points:If};i.linear=Ff,i.stepped=Bg,i.bars=zg,i.spline=Vg}const Qg="Hand in",e_="To hand in: press Stand up, push the robot, then save the hand-in within a minute, without any other change.",t_=".",n_="Certify",i_="{text}",s_="Results as CSV",r_="To join the class",o_="English",a_="upright lab",l_="Skip to the controls",c_="Connecting …",u_="Live",h_="No connection; trying again",d_="Recording",f_="This page has stopped",p_="Light or dark",m_="Keys and mouse",g_="Close",__="The robot in its room. Drag its body to push it; drag the floor to change the view.",v_="{body} leans {pitch} degrees and has rolled {way} centimetres.",x_="{body} has fallen.",M_="twin",S_="nonlinear",y_="linear",b_="published",E_="calibrated",w_="MuJoCo; replaces hardware",T_="Drag the robot to push it",A_="It fell.",R_="Stand up",C_="Tilt 0.1 rad",P_="Pause",L_="Play",D_="One period",N_="Speed",I_="Back in time",U_="now",F_="Pushes",O_="Hold front",k_="A force on the front that holds a lean of +0.1 rad for 3 s and is then released (the paper's first push)",B_="Hold back",z_="A force on the back that holds a lean of −0.12 rad for 3 s and is then released (the paper's second push)",H_="Knock",V_="Pull left wheel",G_="Pull right wheel",W_="Knock by",$_="Arrow keys drive and turn",X_="pitch",q_="pitch rate",Y_="wheel angle",j_="wheel rate",K_="yaw",Z_="yaw rate",J_="Traces of the last seconds",Q_="Seconds shown",e0="Settings, views and files",t0="Controller",n0="Robot",i0="Kit",s0="See",r0="Identify",o0="Keep",a0="Tour",l0="Class",c0="Method",u0="LQG: Kalman filter with dead time",h0="LQR with a Kalman filter",d0="LQI: LQG with an integral of the wheel angle",f0="PID cascade",p0="H∞",m0="MPC: predictive, keeps limits",g0="Sliding mode",_0="Robust: one gain for many robots",v0="Gains by hand: u = −K x",x0="No controller",M0="Largest accepted deviations (Bryson's rule): smaller means stricter",S0="command",y0="Back to the default weights",b0="This method has no weights to set here.",E0="Designing …",w0="Gain K on the left motor",T0="Gain K",A0="Margins at the motors",R0="gain",C0="phase",P0="more delay",L0="unlimited",D0="Certificate",N0="green: may drive",I0="amber: with care",U0="red: should not drive",F0="computing …",O0="none",k0="Full certificate",B0="Robot",z0="Open robot.toml",H0="Parameters",V0="The controller is designed for these parameters.",G0="Back to the preset's parameters",W0="Payload unknown to the controller",$0="Height of the payload above the axle",X0="Slope of the floor",q0="Grip of the wheels (twin)",Y0="Bodies to compare",j0="Electronics",K0="ideal: nothing between controller and motors",Z0="Noise, quanta and bias of the sensors",J0="Dead time",Q0="Battery",ev="Dead zone of the motors",tv="Back to the kit's values",nv="Loop",iv="Bode plot of the loop broken at both motors",sv="Nyquist plot",rv="Closed-loop poles",ov="Phase portrait",av="Voltage",lv="Voltage at the left and right motor; bars mark saturation.",cv="Torque of the left and right motor; bars mark saturation.",uv="Estimate",hv="The controller's estimate of the pitch, and the true pitch.",dv="This controller estimates no state: it reads the true state, or nothing.",fv="Equations",pv="v in volts, or in the unit of the torque. Dry and rolling friction, slope and pushes are added to these.",mv="left",gv="right",_v="truth",vv="estimate",xv="saturated",Mv="Linearised about upright, ẋ = A x + B u",Sv="Open-loop poles",yv="Log to use",bv="this run (the last minute)",Ev="Open a log",wv="Doctor",Tv="Finds faults of the log: units, signs, delays, bias …",Av="Calibrate",Rv="Estimates the robot's parameters from its raw sensors; the calibrated model is shown as a further trace",Cv="Compare",Pv="A page with numbers and figures of all bodies over the last minute, and of the opened log",Lv="Stop",Dv="A calibration needs motion: push and drive the robot for half a minute first.",Nv="Log",Iv="The files hold the run since the last change, at most the last minute.",Uv="Log as CSV",Fv="Log as Parquet",Ov="Report",kv="Replay page",Bv="Controller file",zv="Robot file",Hv="Picture",Vv="Copy link",Gv="Link copied. It restores this whole set-up.",Wv="{name} is ready",$v="Recovered from {impulse} N s; largest so far {best} N s",Xv="Fell after {impulse} N s",qv="Reading {name}",Yv="{force} N",jv="Board",Kv="Name",Zv="Largest push [N s]",Jv="Effort",Qv="Send my set-up to everyone",ex="Your name",tx="Token",nx="Join",ix="Join the class",sx="Step {n} of 8",rx="Do",ox="Watch",ax="Think",lx="Set it up",cx="Next",ux="Previous",hx=[["Mouse on the robot","drag and hold to push"],["Mouse on the floor","drag to change the view, scroll to zoom"],["← → ↑ ↓","turn and drive; a gamepad's left stick does the same"],["F, B","push from the front, from the back, while the key is held"],["K","knock"],["Space","pause and continue"],[".","one period"],[", and /","back and forth in time, while paused"],["S","stand up"],["1 … 8","open a tab"],["N, P","next and previous step of the tour; Enter sets it up"],["[ ] { } + −","change the view and zoom, while the room has the focus"],["?","this list"]],dx=[{title:"It falls by itself",do:"There is no controller. The robot starts with a lean of 0.02 rad.",watch:"ψ grows like an exponential, because one open-loop pole lies in the right half-plane.",ask:"How long until the lean has doubled? Compare with ln 2 divided by the unstable pole (See, Equations)."},{title:"Linearise",do:"Only the two models start, without a controller, from a small lean.",watch:"At first the nonlinear and the linear trace agree. They separate at about 0.5 rad.",ask:"Which term of the equations does the linear model approximate? Look at sin ψ."},{title:"Regulate",do:"An LQR balances it now. Tilt it, and change the accepted pitch under Controller.",watch:"Smaller accepted pitch: larger gain, quicker return, more voltage.",ask:"How do the margins change when the accepted pitch gets smaller? What is the price of a quick return?"},{title:"Push the front",do:"Press Hold front: a force on the front holds ψ at 0.1 rad, and is then released.",watch:"The robot leans into the force. After the release it rolls, overshoots and comes back.",ask:"Why does a push on the front hold a forward lean? Think of the sum of moments."},{title:"Push the back",do:"Press Hold back: −0.12 rad, then released.",watch:"The same response, mirrored and a little larger. φ hardly moves.",ask:"Is the response exactly the mirror image? What would make the two sides differ?"},{title:"Compare",do:"Push twin and models in the same way. Then open Identify and press Compare.",watch:"Shapes agree, settling times differ: the linear model settles differently from the others.",ask:"Which of the six signals differs most, and which physical effect is behind it?"},{title:"Break the linear model",do:"The robot carries a payload that neither the controller nor the linear model includes. Push harder.",watch:"The linear ghost moves differently; the twin sways or falls.",ask:"How large a payload does the margin allow? Find the limit."},{title:"Make it robust",do:"A robust design has one gain for many robots. Repeat your pushes.",watch:"It balances where the previous regulator fell, perhaps more slowly. The light of the certificate shows the risk.",ask:"What did robustness cost? Compare effort and travel in a report."}],fx="This robot cannot be simulated. The one before it stands here again.",px="That was too much at once: some of it was left out. Wait a moment.",mx="The simulation stopped and was started again. All robots stand upright.",gx="Your last change stopped the simulation for all. The usual robot stands here instead.",go={handIn:Qg,handInNote:e_,decimal:t_,certify:n_,original:i_,results:s_,invite:r_,language:o_,title:a_,skip:l_,connecting:c_,connected:u_,lost:h_,replaying:d_,refused:f_,theme:p_,help:m_,close:g_,scene:__,sceneNow:v_,fellNow:x_,twin:M_,nonlinear:S_,linear:y_,published:b_,calibrated:E_,twinNote:w_,hint:T_,fallen:A_,standUp:R_,tilt:C_,pause:P_,play:L_,step:D_,speed:N_,back:I_,now:U_,pushes:F_,front:O_,frontTip:k_,backPush:B_,backTip:z_,impulse:H_,pullLeft:V_,pullRight:G_,size:W_,drive:$_,pitch:X_,pitch_rate:q_,wheel:Y_,wheel_rate:j_,yaw:K_,yaw_rate:Z_,charts:J_,window:Q_,tabs:e0,tabController:t0,tabRobot:n0,tabKit:i0,tabSee:s0,tabIdentify:r0,tabKeep:o0,tabTour:a0,tabClass:l0,family:c0,lqg:u0,lqr:h0,"lqr-complementary":"LQR with a complementary filter","lqr-state":"LQR on the true state (simulation only)",lqi:d0,pid:f0,hinf:p0,mpc:m0,sliding:g0,robust:_0,gains:v0,off:x0,weights:M0,command:S0,ownWeights:y0,noWeights:b0,designing:E0,gain:w0,gainBoth:T0,margins:A0,gainMargin:R0,phaseMargin:C0,delayMargin:P0,unlimited:L0,certificate:D0,green:N0,amber:I0,red:U0,none:F0,noCertificate:O0,fullCertificate:k0,preset:B0,openRobot:z0,numbers:H0,numbersNote:V0,ownNumbers:G0,payload:W0,payloadHeight:$0,slope:X0,grip:q0,bodies:Y0,kit:j0,ideal:K0,noise:Z0,delay:J0,voltage:Q0,deadZone:ev,ownKit:tv,loop:nv,bode:iv,nyquist:sv,poles:rv,portrait:ov,voltages:av,voltagesNote:lv,torquesNote:cv,estimate:uv,estimateNote:hv,noEstimate:dv,equations:fv,equationsNote:pv,leftMotor:mv,rightMotor:gv,truth:_v,opinion:vv,saturated:xv,linearised:Mv,openPoles:Sv,source:yv,thisRun:bv,openLog:Ev,doctor:wv,doctorTip:Tv,calibrate:Av,calibrateTip:Rv,compare:Cv,compareTip:Pv,stop:Lv,calibrateNote:Dv,log:Nv,keepNote:Iv,csv:Uv,parquet:Fv,report:Ov,replay:kv,controllerFile:Bv,robotFile:zv,picture:Hv,link:Vv,linkCopied:Gv,made:Wv,recovered:$v,lostPush:Xv,uploaded:qv,newtons:Yv,board:jv,name:Kv,bestPush:Zv,effort:Jv,broadcast:Qv,yourName:ex,token:tx,enter:nx,joinTitle:ix,tourStep:sx,tourDo:rx,tourWatch:ox,tourAsk:ax,tourSet:lx,next:cx,previous:ux,keys:hx,tour:dx,setBack:fx,tooMany:px,restarted:mx,ended:gx},_x="Entregar",vx="Para entregar: pulse Poner de pie, empuje el robot y guarde la entrega antes de un minuto, sin cambiar nada más.",xx=",",Mx="Certificar",Sx="Mensaje original: {text}",yx="Resultados en CSV",bx="Para unirse a la clase",Ex="Español",wx="lab upright",Tx="Ir a los controles",Ax="Conectando …",Rx="En vivo",Cx="Sin conexión; se intenta de nuevo",Px="Grabación",Lx="Esta página se ha detenido",Dx="Claro u oscuro",Nx="Teclas y ratón",Ix="Cerrar",Ux="El robot en su sala. Arrastre su cuerpo para empujarlo; arrastre el suelo para cambiar la vista.",Fx="{body} se inclina {pitch} grados y ha rodado {way} centímetros.",Ox="{body} se ha caído.",kx="gemelo",Bx="no lineal",zx="lineal",Hx="publicado",Vx="calibrado",Gx="MuJoCo; sustituye al robot real",Wx="Arrastre el robot para empujarlo",$x="Se cayó.",Xx="Poner de pie",qx="Inclinar 0,1 rad",Yx="Pausa",jx="Continuar",Kx="Un período",Zx="Velocidad",Jx="Atrás en el tiempo",Qx="ahora",eM="Empujones",tM="Sostener por delante",nM="Una fuerza por delante que mantiene +0,1 rad durante 3 s y luego cesa (el primer empujón del artículo)",iM="Sostener por detrás",sM="Una fuerza por detrás que mantiene −0,12 rad durante 3 s y luego cesa (el segundo empujón del artículo)",rM="Golpe",oM="Tirar de la rueda izquierda",aM="Tirar de la rueda derecha",lM="Golpe de",cM="Las flechas conducen y giran",uM="inclinación",hM="velocidad de inclinación",dM="ángulo de ruedas",fM="velocidad de ruedas",pM="rumbo",mM="velocidad de giro",gM="Trazas de los últimos segundos",_M="Segundos mostrados",vM="Ajustes, vistas y archivos",xM="Controlador",MM="Robot",SM="Electrónica",yM="Ver",bM="Identificar",EM="Guardar",wM="Recorrido",TM="Clase",AM="Método",RM="LQG: filtro de Kalman con retardo",CM="LQR con filtro de Kalman",PM="LQI: LQG con integral del ángulo de ruedas",LM="PID en cascada",DM="H∞",NM="MPC: predictivo, respeta límites",IM="Modo deslizante",UM="Robusto: una ganancia para muchos robots",FM="Ganancias a mano: u = −K x",OM="Sin controlador",kM="Mayores desviaciones aceptadas (regla de Bryson): menor es más estricto",BM="mando",zM="Volver a los pesos predeterminados",HM="Este método no tiene pesos que ajustar aquí.",VM="Diseñando …",GM="Ganancia K del motor izquierdo",WM="Ganancia K",$M="Márgenes en los motores",XM="ganancia",qM="fase",YM="más retardo",jM="sin límite",KM="Certificado",ZM="verde: puede conducir",JM="ámbar: con cuidado",QM="rojo: no debe conducir",eS="calculando …",tS="ninguno",nS="Certificado completo",iS="Robot",sS="Abrir robot.toml",rS="Parámetros",oS="El controlador se diseña para estos parámetros.",aS="Volver a los parámetros del preajuste",lS="Carga que el controlador desconoce",cS="Altura de la carga sobre el eje",uS="Pendiente del suelo",hS="Agarre de las ruedas (gemelo)",dS="Cuerpos que se comparan",fS="Electrónica",pS="ideal: nada entre controlador y motores",mS="Ruido, cuantos y sesgo de los sensores",gS="Retardo",_S="Batería",vS="Zona muerta de los motores",xS="Volver a los valores de la electrónica",MS="Lazo",SS="Diagrama de Bode del lazo abierto en ambos motores",yS="Diagrama de Nyquist",bS="Polos en lazo cerrado",ES="Plano de fase",wS="Tensión",TS="Tensión en el motor izquierdo y en el derecho; las barras marcan saturación.",AS="Par del motor izquierdo y del derecho; las barras marcan saturación.",RS="Estimación",CS="La inclinación estimada por el controlador y la verdadera.",PS="Este controlador no estima el estado: lee el verdadero, o nada.",LS="Ecuaciones",DS="v en voltios, o en la unidad del par. A esto se suman fricción seca y de rodadura, pendiente y empujones.",NS="izquierdo",IS="derecho",US="verdad",FS="estimación",OS="saturado",kS="Linealizado en vertical, ẋ = A x + B u",BS="Polos en lazo abierto",zS="Registro que se usa",HS="este ensayo (el último minuto)",VS="Abrir un registro",GS="Doctor",WS="Busca fallos del registro: unidades, signos, retardos, sesgo …",$S="Calibrar",XS="Estima los parámetros del robot a partir de sus sensores; el modelo calibrado se muestra como otra traza",qS="Comparar",YS="Una página con números y figuras de todos los cuerpos en el último minuto, y del registro abierto",jS="Parar",KS="Una calibración necesita movimiento: empuje y conduzca el robot medio minuto antes.",ZS="Registro",JS="Los archivos contienen el ensayo desde el último cambio, como mucho el último minuto.",QS="Registro CSV",ey="Registro Parquet",ty="Informe",ny="Página con la grabación",iy="Archivo del controlador",sy="Archivo del robot",ry="Imagen",oy="Copiar enlace",ay="Enlace copiado. Restaura toda esta configuración.",ly="{name} está listo",cy="Se recuperó de {impulse} N s; el mayor hasta ahora {best} N s",uy="Se cayó tras {impulse} N s",hy="Se está leyendo {name}",dy="{force} N",fy="Clasificación",py="Nombre",my="Mayor empujón [N s]",gy="Esfuerzo",_y="Enviar mi configuración a todos",vy="Su nombre",xy="Clave",My="Entrar",Sy="Unirse a la clase",yy="Paso {n} de 8",by="Haga",Ey="Observe",wy="Piense",Ty="Preparar",Ay="Siguiente",Ry="Anterior",Cy=[["Ratón sobre el robot","arrastrar y mantener para empujar"],["Ratón sobre el suelo","arrastrar para cambiar la vista, rueda para acercarse"],["← → ↑ ↓","girar y conducir; la palanca izquierda de un mando hace lo mismo"],["F, B","empujar por delante, por detrás, mientras se mantenga la tecla"],["K","golpe"],["Espacio","pausa y continuar"],[".","un período"],[", y /","atrás y adelante en el tiempo, en pausa"],["S","poner de pie"],["1 … 8","abrir una pestaña"],["N, P","paso siguiente y anterior del recorrido; Intro lo prepara"],["[ ] { } + −","cambiar la vista y acercarse, con el foco en la sala"],["?","esta lista"]],Py=[{title:"Se cae solo",do:"No hay controlador. El robot empieza con una inclinación de 0,02 rad.",watch:"ψ crece como una exponencial, porque un polo en lazo abierto está en el semiplano derecho.",ask:"¿Cuánto tarda en duplicarse la inclinación? Compare con ln 2 entre el polo inestable (Ver, Ecuaciones)."},{title:"Linealizar",do:"Solo arrancan los dos modelos, sin controlador, desde una inclinación pequeña.",watch:"La traza no lineal y la lineal coinciden al principio y se separan hacia 0,5 rad.",ask:"¿Qué término de las ecuaciones aproxima el modelo lineal? Mire sen ψ."},{title:"Regular",do:"Ahora un LQR lo equilibra. Inclínelo y cambie la inclinación aceptada en Controlador.",watch:"Menor inclinación aceptada: mayor ganancia, regreso más rápido, más tensión.",ask:"¿Cómo cambian los márgenes con una inclinación aceptada menor? ¿Qué cuesta un regreso rápido?"},{title:"Empujar por delante",do:"Pulse Sostener por delante: una fuerza por delante mantiene ψ en 0,1 rad y luego cesa.",watch:"El robot se inclina contra la fuerza. Al soltarlo rueda, se pasa y vuelve.",ask:"¿Por qué un empujón por delante mantiene una inclinación hacia delante? Piense en la suma de momentos."},{title:"Empujar por detrás",do:"Pulse Sostener por detrás: −0,12 rad, y luego la fuerza cesa.",watch:"La misma respuesta, reflejada y algo mayor. φ apenas se mueve.",ask:"¿Es la respuesta exactamente la imagen reflejada? ¿Qué haría diferentes los dos lados?"},{title:"Comparar",do:"Empuje del mismo modo el gemelo y los modelos. Luego abra Identificar y pulse Comparar.",watch:"Las formas coinciden, los tiempos de establecimiento no: el modelo lineal se asienta de otro modo.",ask:"¿Cuál de las seis señales difiere más, y qué efecto físico hay detrás?"},{title:"Romper el modelo lineal",do:"El robot lleva una carga que ni el controlador ni el modelo lineal incluyen. Empuje más fuerte.",watch:"El fantasma lineal se mueve de otro modo; el gemelo oscila o cae.",ask:"¿Qué carga permite el margen? Busque el límite."},{title:"Hacerlo robusto",do:"Un diseño robusto tiene una ganancia para muchos robots. Repita sus empujones.",watch:"Se mantiene donde cayó el regulador anterior, quizá más despacio. La luz del certificado muestra el riesgo.",ask:"¿Qué costó la robustez? Compare esfuerzo y recorrido en un informe."}],Ly="Este robot no se puede simular. El anterior está de nuevo aquí.",Dy="Fue demasiado a la vez: una parte se omitió. Espere un momento.",Ny="La simulación se detuvo y comenzó de nuevo. Todos los robots están de pie.",Iy="Su último cambio detuvo la simulación para todos. Aquí está el robot habitual en su lugar.",Uy={handIn:_x,handInNote:vx,decimal:xx,certify:Mx,original:Sx,results:yx,invite:bx,language:Ex,title:wx,skip:Tx,connecting:Ax,connected:Rx,lost:Cx,replaying:Px,refused:Lx,theme:Dx,help:Nx,close:Ix,scene:Ux,sceneNow:Fx,fellNow:Ox,twin:kx,nonlinear:Bx,linear:zx,published:Hx,calibrated:Vx,twinNote:Gx,hint:Wx,fallen:$x,standUp:Xx,tilt:qx,pause:Yx,play:jx,step:Kx,speed:Zx,back:Jx,now:Qx,pushes:eM,front:tM,frontTip:nM,backPush:iM,backTip:sM,impulse:rM,pullLeft:oM,pullRight:aM,size:lM,drive:cM,pitch:uM,pitch_rate:hM,wheel:dM,wheel_rate:fM,yaw:pM,yaw_rate:mM,charts:gM,window:_M,tabs:vM,tabController:xM,tabRobot:MM,tabKit:SM,tabSee:yM,tabIdentify:bM,tabKeep:EM,tabTour:wM,tabClass:TM,family:AM,lqg:RM,lqr:CM,"lqr-complementary":"LQR con filtro complementario","lqr-state":"LQR con el estado verdadero (solo simulado)",lqi:PM,pid:LM,hinf:DM,mpc:NM,sliding:IM,robust:UM,gains:FM,off:OM,weights:kM,command:BM,ownWeights:zM,noWeights:HM,designing:VM,gain:GM,gainBoth:WM,margins:$M,gainMargin:XM,phaseMargin:qM,delayMargin:YM,unlimited:jM,certificate:KM,green:ZM,amber:JM,red:QM,none:eS,noCertificate:tS,fullCertificate:nS,preset:iS,openRobot:sS,numbers:rS,numbersNote:oS,ownNumbers:aS,payload:lS,payloadHeight:cS,slope:uS,grip:hS,bodies:dS,kit:fS,ideal:pS,noise:mS,delay:gS,voltage:_S,deadZone:vS,ownKit:xS,loop:MS,bode:SS,nyquist:yS,poles:bS,portrait:ES,voltages:wS,voltagesNote:TS,torquesNote:AS,estimate:RS,estimateNote:CS,noEstimate:PS,equations:LS,equationsNote:DS,leftMotor:NS,rightMotor:IS,truth:US,opinion:FS,saturated:OS,linearised:kS,openPoles:BS,source:zS,thisRun:HS,openLog:VS,doctor:GS,doctorTip:WS,calibrate:$S,calibrateTip:XS,compare:qS,compareTip:YS,stop:jS,calibrateNote:KS,log:ZS,keepNote:JS,csv:QS,parquet:ey,report:ty,replay:ny,controllerFile:iy,robotFile:sy,picture:ry,link:oy,linkCopied:ay,made:ly,recovered:cy,lostPush:uy,uploaded:hy,newtons:dy,board:fy,name:py,bestPush:my,effort:gy,broadcast:_y,yourName:vy,token:xy,enter:My,joinTitle:Sy,tourStep:yy,tourDo:by,tourWatch:Ey,tourAsk:wy,tourSet:Ty,next:Ay,previous:Ry,keys:Cy,tour:Py,setBack:Ly,tooMany:Dy,restarted:Ny,ended:Iy},Fy=JSON.parse(`[["there is no run to hand in; expected one of at most {0} s, with no change since Stand up; try: press Stand up, push the robot, then hand in","no hay un ensayo que entregar de {0} s como máximo y sin cambios desde Poner de pie; pruebe: pulse Poner de pie, empuje el robot y entregue"],["{0} of {1} robots fell, {2} of them after a {3} at {4} battery: {5}","cayeron {0} de {1} robots, {2} de ellos tras {3} con batería {4}: {5}"],["{0} of {1} robots fell: {2}","cayeron {0} de {1} robots: {2}"],["the probability of a fall is below {0}","la probabilidad de caída es menor que {0}"],["the probability of a fall may be {0}, more than {1}","la probabilidad de caída puede ser de {0}, más de {1}"],["no linear margins are known","no se conocen márgenes lineales"],["stable with {0}","estable con {0}"],["the nominal loop is unstable, with a pole at |z| = {0}","el lazo nominal es inestable, con un polo en |z| = {0}"],["a signal {0} % stronger at {1} makes the loop unstable","una señal un {0} % mayor en {1} vuelve inestable el lazo"],["a signal {0} % weaker at {1} makes the loop unstable","una señal un {0} % menor en {1} vuelve inestable el lazo"],["motors {0} % stronger make the loop unstable","motores un {0} % más fuertes vuelven inestable el lazo"],["motors {0} % weaker make the loop unstable","motores un {0} % más débiles vuelven inestable el lazo"],["{0} ms more delay at {1} ({2} of a period) make the loop unstable","{0} ms más de retardo en {1} ({2} de un período) vuelven inestable el lazo"],["{0} ms more delay ({1} of a period) make the loop unstable","{0} ms más de retardo ({1} de un período) vuelven inestable el lazo"],["a motor is at its limit for {0} of the time after a {1} at {2} battery","un motor está en su límite el {0} del tiempo tras {1} con batería {2}"],["the robot rolls {0} m away after a {1} at {2} battery","el robot rueda {0} m tras {1} con batería {2}"],["at rest the robot sways by ±{0} rad after a {1} at {2} battery","en reposo el robot oscila ±{0} rad tras {1} con batería {2}"],["in a class, the certificate is computed on request","en una clase, el certificado se calcula cuando se pide"],["The loop is unstable: its largest pole is at |z| = {0}.","El lazo es inestable: su mayor polo está en |z| = {0}."],["{0}: unstable, so there is no margin.","{0}: inestable, así que no hay margen."],["{0}: survives {1}, and {2} or {3} of its gain.","{0}: soporta {1}, y una ganancia {2} o {3}."],["as weak as {0} %","de solo el {0} %"],["however weak","tan pequeña como se quiera"],["as strong as {0} %","de hasta el {0} %"],["however strong","tan grande como se quiera"],["{0} ms more delay at the {1}","{0} ms más de retardo en {1}"],["{0} ms more delay at {1}","{0} ms más de retardo en {1}"],["{0} ms more delay","{0} ms más de retardo"],["any delay at the {0}","cualquier retardo en {0}"],["any delay","cualquier retardo"],["a {0} has no known linear form","un controlador {0} no tiene forma lineal conocida"],["both motors","ambos motores"],["left motor","motor izquierdo"],["right motor","motor derecho"],["steering","giro"],["gyro","giróscopo"],["compass","brújula"],["left encoder","codificador izquierdo"],["right encoder","codificador derecho"],["encoder left","codificador izquierdo"],["encoder right","codificador derecho"],["both encoders","ambos codificadores"],["accelerometer","acelerómetro"],["the gyro","el giróscopo"],["the compass","la brújula"],["the left motor","el motor izquierdo"],["the right motor","el motor derecho"],["the left encoder","el codificador izquierdo"],["the right encoder","el codificador derecho"],["low","baja"],["full","plena"],["hold in front","sostener por delante"],["hold behind","sostener por detrás"],["front","por delante"],["back","por detrás"],["knock by {0} m/s","golpe de {0} m/s"],["hold at {0} rad","sostener a {0} rad"],["front hold","sostener por delante"],["back hold","sostener por detrás"],["push","empuje"],["battery","batería"],["fell","cayeron"],["saturated","saturado"],["travel [m]","recorrido [m]"],["peak [rad]","máximo [rad]"],["{0} on {1}: green","{0} en {1}: verde"],["{0} on {1}: amber","{0} en {1}: ámbar"],["{0} on {1}: red","{0} en {1}: rojo"],["certify: stopped","certificado: parado"],["doctor: stopped","doctor: parado"],["calibrate: stopped","calibración: parada"],["design: stopped","diseño: parado"],["{0}: read","{0}: leído"],["nothing was recorded yet; try: let it run for a moment","todavía no se grabó nada; pruebe: déjelo andar un momento"],["there is no file '{0}' here; try: upload it again","no hay un archivo '{0}' aquí; pruebe: ábralo otra vez"],["this run","este ensayo"],["{0}: {1} rows, {2} s, every {3} ms","{0}: {1} filas, {2} s, cada {3} ms"],["Nothing found: this log can be used as it is.","No se encontró nada: este registro puede usarse como está."],["what","qué"],["channel","canal"],["evidence","prueba"],["repair","arreglo"],["error","error"],["warning","aviso"],["note","nota"],["{0} of {1} readings repeat the previous one while the channel moves ({2}; {3} expected by chance), the first near {4} s","{0} de {1} lecturas repiten la anterior mientras el canal se mueve ({2}; por azar se esperan {3}), la primera cerca de {4} s"],["{0} of the rows are at the {1}, {2}, up to {3} consecutive","{0} de las filas están en el límite ({2}), hasta {3} seguidas"],["exclude these rows from a linear fit, or model the limit","excluir estas filas de un ajuste lineal, o modelar el límite"],["mean {0} rad/s over {1} s, a drift of {2} rad; at most {3} rad/s is plausible for a robot upright at both ends","media {0} rad/s durante {1} s, una deriva de {2} rad; para un robot de pie al principio y al final son plausibles {3} rad/s como máximo"],["resolution {0} rad ({1} counts per turn); differences of rows have a noise of {2} rad/s, the motion {3} rad/s","resolución {0} rad ({1} cuentas por vuelta); las diferencias entre filas tienen un ruido de {2} rad/s, el movimiento {3} rad/s"],["the pitch amplitude is only {0} rad: resolution and friction are as large as the dynamics","la amplitud de la inclinación es solo de {0} rad: resolución y fricción son tan grandes como la dinámica"],["its difference from the gyro follows {0} (partial R² {1}); its error while accelerating reaches {2} rad","su diferencia con el giróscopo sigue a la aceleración (R² parcial {1}); su error al acelerar llega a {2} rad"],["delayed by {0} relative to the {1}, by the pendulum equation (R² {2})","retrasado {0} respecto a {1}, según la ecuación del péndulo (R² {2})"],["the wheels respond {0} ms and the gyro {1} ms after a command ({2})","las ruedas responden {0} ms y el giróscopo {1} ms después de un mando"],["the unpredictable part of the command, {0} on both sides, turns the wheels forward (t = {1})","la parte impredecible del mando gira las ruedas hacia delante (t = {1})"],["the unpredictable part of the command, {0} on both sides, turns the wheels backward (t = {1})","la parte impredecible del mando gira las ruedas hacia atrás (t = {1})"],["each motor drives the other wheel: an unpredictable left-turn command turns them right (t = {0})","cada motor mueve la otra rueda: un mando impredecible a la izquierda gira a la derecha (t = {0})"],["log at the controller's rate; one-step regression on this log is biased","registrar al ritmo del controlador; la regresión de un paso en este registro está sesgada"],["if the controller is faster, log at its rate; one-step regression on this log is biased","si el controlador es más rápido, registrar a su ritmo; la regresión de un paso en este registro está sesgada"],["if commands were held for {0} ms, the wheels would lead by {1} ms (motor equation, R² {2}): the commands changed between the rows","si los mandos se mantuvieran {0} ms, las ruedas se adelantarían {1} ms (ecuación del motor, R² {2}): los mandos cambiaron entre las filas"],["the unpredictable part of the command moves the wheels {0} (± {1}) of the distance expected if held for {2} ms: the commands changed between the rows, or friction absorbs the small ones","la parte impredecible del mando mueve las ruedas el {0} (± {1}) de lo esperado si se mantuviera {2} ms: los mandos cambiaron entre las filas, o la fricción absorbe los pequeños"],["from t = {0} s the pitch turns by {1} rad at up to {2} rad/s, {3}","desde t = {0} s la inclinación gira {1} rad a hasta {2} rad/s: una caída"],["from {0} to {1} s {2}: signs, units, delays and offsets are not judged there","de {0} a {1} s {2}: allí no se juzgan signos, unidades, retardos ni desviaciones"],["the robot lies","el robot yace"],["the robot lies after its fall","el robot yace tras su caída"],["the robot is upside down","el robot está cabeza abajo"],["the robot stands up","el robot se levanta"],["the robot is thrown, lifted or carried","el robot es lanzado, levantado o llevado"],["the robot balances nowhere in this log: no sign, unit, delay or offset can be judged","el robot no se equilibra en ningún momento de este registro: no se puede juzgar nada"],["the longest time on the wheels is from {0} to {1} s","el tiempo más largo sobre las ruedas es de {0} a {1} s"],["from {0} to {1} s (rows {2} to {3}) the wheels stand still and the gyro reads noise of {4} rad/s, with a mean command of {5}: held by hand, or stuck by friction","de {0} a {1} s (filas {2} a {3}) las ruedas no se mueven y el giróscopo lee un ruido de {4} rad/s, con un mando medio de {5}: sostenido con la mano, o parado por la fricción"],["from {0} to {1} s the wheels deviate from the pendulum equation by up to {2} rad/s², {3} standard deviations, in both directions: the wheels slip","de {0} a {1} s las ruedas se apartan de la ecuación del péndulo hasta {2} rad/s², {3} desviaciones típicas, en ambos sentidos: las ruedas patinan"],["from {0} to {1} s the wheels deviate from the pendulum equation by up to {2} rad/s², {3} standard deviations, in one direction: a push","de {0} a {1} s las ruedas se apartan de la ecuación del péndulo hasta {2} rad/s², {3} desviaciones típicas, en un sentido: un empuje"],["remove them","quitarlas"],["keep the first row of each time","conservar la primera fila de cada instante"],["sort the rows, keep one for each time","ordenar las filas y conservar una de cada instante"],["interpolate them linearly","interpolarlas linealmente"],["resample at even times","remuestrear a intervalos iguales"],["use the parts as separate logs","usar las partes como registros separados"],["use the times of the log, as every command does, not row × period","usar los tiempos del registro, como hace cada orden, no fila × período"],["drop the channel","descartar el canal"],["check the cable and the mapped column","revisar el cable y la columna asignada"],["subtract {0} rad/s","restar {0} rad/s"],["fit the angles, not their differences","ajustar los ángulos, no sus diferencias"],["do not take differences of single rows","no tomar diferencias de filas sueltas"],["excite the robot before identifying inertias","excitar el robot antes de identificar inercias"],["fit gyro and encoders, not this estimate","ajustar giróscopo y codificadores, no esta estimación"],["multiply by −1","multiplicar por −1"],["multiply by {0}","multiplicar por {0}"],["divide by {0}","dividir entre {0}"],["shift it {0} earlier","adelantarlo {0}"],["include this dead time in the model, or shift the commands","incluir este tiempo muerto en el modelo, o desplazar los mandos"],["integrate both encoders","integrar ambos codificadores"],["differentiate it","derivarlo"],["swap left and right command","intercambiar mando izquierdo y derecho"],["exclude it from a fit","excluirlo de un ajuste"],["exclude these rows from a fit","excluir estas filas de un ajuste"],["exclude these rows from a fit, or log the push","excluir estas filas de un ajuste, o registrar el empuje"],["log a robot that balances","registrar un robot que se equilibra"],["use {0} s","usar {0} s"],["{0} of {1} readings are missing, the first at row {2}","faltan {0} de {1} lecturas, la primera en la fila {2}"],["all readings are missing","faltan todas las lecturas"],["it is {0} in all {1} rows","vale {0} en las {1} filas"],["{0} rows are missing at {1} places, the first after t = {2} s: steps of two or more periods of {3} ms","faltan {0} filas en {1} lugares, la primera tras t = {2} s: pasos de dos o más períodos de {3} ms"],["{0} from {1} samples","{0} a partir de {1} muestras"],["parameter","parámetro"],["value","valor"],["95 %","95 %"],["prior","a priori"],["unit","unidad"],["what the log tells","lo que dice el registro"],["visible","visible"],["prior dominates","domina el a priori"],["at its bound","en su límite"],["not fitted","no ajustado"],["refused","rechazado"],["wheel mass","masa de una rueda"],["wheel radius","radio de la rueda"],["wheel inertia","inercia de una rueda"],["body mass","masa del cuerpo"],["track","ancho de vía"],["com height","altura del centro de masa"],["pitch inertia","inercia de cabeceo"],["yaw inertia","inercia de guiñada"],["roll inertia","inercia de balanceo"],["rotor inertia","inercia del rotor"],["gear ratio","relación de transmisión"],["motor resistance","resistencia del motor"],["back emf","constante contraelectromotriz"],["torque constant","constante de par"],["motor friction","fricción del motor"],["wheel friction","fricción de la rueda"],["coulomb friction","fricción seca"],["stiction rate","velocidad de suavizado"],["gravity","gravedad"],["body depth","fondo del cuerpo"],["body height","altura del cuerpo"],["asymmetry","asimetría de los motores"],["dead zone","zona muerta"],["constant command","mando constante"],["roll fraction","fracción de balanceo"],["motor gain","ganancia del motor"],["motor damping","amortiguamiento del motor"],["delay/gyro−encoder","retardo giróscopo−codificador"],["delay/{0}","retardo/{0}"],["command","mando"],["encoder","codificador"],["TWIPR (small BILBO): torque-controlled motors, centre of mass just above the axle.","TWIPR (BILBO pequeño): motores controlados en par, centro de masa apenas sobre el eje."],["The NXTway-GS design rebuilt with LEGO EV3 parts and motors, on small wheels of 21.5 mm radius; on large wheels: ev3way-large-wheels.","El diseño NXTway-GS con piezas y motores LEGO EV3, sobre ruedas pequeñas de 21,5 mm de radio; con ruedas grandes: ev3way-large-wheels."],["Yamamoto's NXTway-GS, the LEGO NXT robot whose published table Herrera et al. (2015) start from.","El NXTway-GS de Yamamoto, el robot LEGO NXT de cuya tabla publicada parten Herrera et al. (2015)."],["NXTway-GS with a rotor inertia of the size that is measured, 150 times the published estimate.","NXTway-GS con una inercia del rotor como la que se mide, 150 veces la estimación publicada."],["The EV3way design on wheels of about 45 mm radius: the LEGO EV3 robot of the published logs of sim2real-ev3way.","El diseño EV3way sobre ruedas de unos 45 mm de radio: el robot LEGO EV3 de los registros publicados de sim2real-ev3way."],["The robot behind the printed linear model of Herrera et al. (2015): twice as tall as NXTway-GS, on half the wheels.","El robot tras el modelo lineal impreso de Herrera et al. (2015): el doble de alto que NXTway-GS, sobre ruedas de la mitad."],["{0}; try: {1}","{0}; pruebe: {1}"],["the token is missing or wrong","la clave falta o no es correcta"],["open the address that your teacher shows","abra la dirección que muestra su docente"],["your name is missing","falta su nombre"],["write a name, so that the board can show it","escriba un nombre para que aparezca en la clasificación"],["every place is taken","todos los lugares están ocupados"],["close another page of the lab first","cierre antes otra página del laboratorio"],["too many messages","demasiados mensajes"],["wait a moment and reload the page","espere un momento y recargue la página"],["wait a minute and reload the page","espere un minuto y recargue la página"],["too many new robots from this address","demasiados robots nuevos desde esta dirección"],["upload it again","ábralo otra vez"]]`),va={en:go,es:Uy};let Mi=go;function zf(){return Object.keys(va).find(i=>va[i]===Mi)??"en"}function Nh(i){Mi=va[i]??go,document.documentElement.lang=zf(),document.title=Mi.title}function Hf(){return Mi}function W(i,e={}){return Mi[i].replace(/\{(\w+)\}/g,(t,n)=>Oy(String(e[n]??"")))}function ai(i){const e=Mi[i];return typeof e=="string"?e:i}function Ns(i){return Mi.decimal==="."?i:i.replace(/(\d)\.(?=\d)/g,`$1${Mi.decimal}`)}function uo(i,e){return Ns(i.toFixed(e).replace("-","−"))}function Oy(i){return/^[−-]?\d+\.\d+$/.test(i)?Ns(i):i}const ky=i=>i.replace(/[.*+?^${}()|[\]\\]/g,"\\$&"),Vf=Fy.map(([i,e])=>[new RegExp(`^${ky(i).replace(/\\\{\d\\\}/g,"(.+?)")}$`,"s"),e]);function Fn(i){if(Mi===go)return i;for(const[e,t]of Vf){const n=e.exec(i);if(n)return t.replace(/\{(\d)\}/g,(s,r)=>Fn(n[Number(r)+1]))}return Ns(i)}function Gf(i){return Mi===go||Vf.some(([e])=>e.test(i))}function B(i,e={},...t){const n=document.createElement(i);for(const[s,r]of Object.entries(e))s.startsWith("on")?n.addEventListener(s.slice(2),r):s.includes("-")||s==="role"||s==="for"||s==="list"?n.setAttribute(s,String(r)):r!==void 0&&(n[s]=r);return n.append(...t.filter(s=>!!s)),n}function xt(i,...e){i.replaceChildren(...e.filter(t=>!!t))}function _t(i,e,t={}){return B("button",{type:"button",onclick:e,...t},i)}let Ih=0;function br(i){return Ih+=1,`${i}-${Ih}`}function si(i,e,t){const n=br("slider"),s=h=>e.log?Math.log(h):h,r=h=>e.log?Math.exp(h):h,o=B("output",{for:n}),a=s(e.high)-s(e.low),l=B("input",{type:"range",id:n,min:String(s(e.low)),max:String(s(e.high)),step:String(e.step??a/200),"data-key":e.key??""}),c=h=>{o.textContent=e.show(h),l.setAttribute("aria-valuetext",e.show(h))};l.addEventListener("input",()=>{const h=r(Number(l.value));c(h),t(h)});const u=h=>{document.activeElement!==l&&(l.value=String(s(Math.max(h,e.log?e.low:-1/0)))),c(h)};return{root:B("div",{className:"slider"},B("label",{for:n},i),o,l),set:u}}function Is(i,e,t,n,s=""){const r=br("select"),o=B("select",{id:r,"data-key":s,onchange:()=>n(o.value)},...e.map(([a,l])=>B("option",{value:a,selected:a===t},l)));return B("div",{className:"choice"},B("label",{for:r},i),o)}function zt(i,e=3){return Number.isFinite(i)?Ns(String(Number(i.toPrecision(e))).replace("-","−").replace("e","·10^")):"∞"}function xa(i,e,t=""){const n=i.length?B("thead",{},B("tr",{},...i.map(r=>B("th",{scope:"col"},r)))):null,s=B("tbody",{},...e.map(r=>B("tr",{},...r.map(o=>B("td",{},o)))));return B("div",{className:"table",tabIndex:0},B("table",{className:t},n,s))}function Wf(i,e){let t=0,n=null;return(...s)=>{n=s,!t&&(e(...s),n=null,t=window.setTimeout(function r(){if(t=0,n){const o=n;n=null,e(...o),t=window.setTimeout(r,i)}},i))}}const By={twin:"#0072b2",nonlinear:"#d55e00",linear:"#00805c",calibrated:"#a0478a",published:"#6b6b00"},zy={twin:"#56b4e9",nonlinear:"#f2843c",linear:"#2fc79b",calibrated:"#dd93bd",published:"#c9c95a"},Hy={nonlinear:[7,4],linear:[2,3],calibrated:[9,3,2,3],published:[12,5]};function Vy(){return document.documentElement.dataset.theme==="dark"}function Ps(i){return(Vy()?zy:By)[i]??"#888888"}function au(i){return Hy[i]??[]}function Er(){const i=getComputedStyle(document.documentElement),e=t=>i.getPropertyValue(t).trim();return{text:e("--ink"),soft:e("--soft"),grid:e("--grid"),paper:e("--card"),push:e("--push")}}const Gy=5,Fa={robot:"nxtway-gs",numbers:{},drive:"",kit:"nxt",noise:1,delay:-1,voltage:-1,dead_zone:-1,grip:10,bodies:["twin","nonlinear","linear"],controller:"lqg",largest:[],gains:[],payload:0,payload_height:.15,slope:0,seed:0},Oa=["pitch","pitch_rate","wheel","wheel_rate","yaw","yaw_rate"],$f=["rad","rad/s","rad","rad/s","rad","rad/s"],Ls=["ψ","ψ̇","θ","θ̇","φ","φ̇"],Uh=3200,Fh=.15,Oh=1e3,Wy=.03,$y=["bodies","payload","payload_height","slope","grip","seed"];function No(i){return JSON.stringify(Object.entries(i).filter(([e])=>!$y.includes(e)))}class lu{t=[];x=[];estimate=[];volts=[[],[]];saturated=[];reset(e){this.t=[],this.x=Array.from({length:e},()=>Oa.map(()=>[])),this.estimate=[],this.volts=[[],[]],this.saturated=[]}add(e){const t=this.t.at(-1);t!==void 0&&e.t<=t||(e.x.length!==this.x.length&&this.reset(e.x.length),this.push(e.t,e.x,e.e[0]??NaN,e.x[0][6],e.x[0][7],e.s),this.t.length>Uh+400&&this.cut(this.t.length-Uh))}push(e,t,n,s,r,o){this.t.push(e),t.forEach((a,l)=>this.x[l].forEach((c,u)=>c.push(a[u]))),this.estimate.push(n),this.volts[0].push(s),this.volts[1].push(r),this.saturated.push(o)}fill(e,t){if(!t.length)return;const n=Math.floor(t[0].length/6);(n!==this.x.length||(this.t.at(-1)??0)>e.at(-1)+1)&&this.reset(n);const s=new lu;s.reset(n);let r=0;const o=a=>{for(;r<e.length&&e[r]<a-.001;r+=1){if(e[r]-(s.t.at(-1)??-1/0)<Wy)continue;const[l,c]=[t[r],t[r].slice(6*n)];s.push(e[r],Array.from({length:n},(u,h)=>l.slice(6*h,6*h+6)),c[0],c[1],c[2],c[3])}};this.t.forEach((a,l)=>{o(a),s.push(a,this.x.map(c=>c.map(u=>u[l])),this.estimate[l],this.volts[0][l],this.volts[1][l],this.saturated[l])}),o(1/0),Object.assign(this,s)}until(e){let t=this.t.length;for(;t>0&&this.t[t-1]>=e;)t-=1;for(const n of this.all())n.length=t}cut(e){for(const t of this.all())t.splice(0,e)}all(){return[this.t,this.estimate,...this.volts,this.saturated,...this.x.flat()]}}class Xy{snapshot=null;traces=new lu;changed=null;catalogue=null;analysed=null;equations=null;lit=null;board=null;found=null;role="alone";session="";files="";invite="";setup=Fa;replaying=!1;send=()=>{};listeners=[];waiting=!1;asked=-Oh;listen(e){this.listeners.push(e)}change(e){this.expect(e),this.send({kind:"Change",setup:this.setup})}expect(e){const t=No(this.setup);this.setup={...this.setup,...e},No(this.setup)!==t&&(this.waiting=!0,this.forget())}forget(){this.analysed=null,this.lit={kind:"Light",light:"none",reasons:[]};for(const e of this.listeners)e(this.lit)}recall(e){const t=this.traces.t.at(-1);if(t===void 0||e.t-t<Fh||performance.now()-this.asked<Oh)return;this.asked=performance.now();const n=this.traces.t.findIndex((s,r)=>r>0&&s>e.t-60&&s-this.traces.t[r-1]>=Fh);this.send({kind:"Recall",since:n<0?t:this.traces.t[n-1]})}hear(e){switch(e.kind){case"Snapshot":this.snapshot=e,e.back||(this.recall(e),this.traces.add(e));break;case"Welcome":this.role=e.role,this.session=e.session,this.files=e.files,this.invite=e.invite;break;case"Catalogue":this.catalogue=e;break;case"Changed":this.changedTo(e);break;case"Analysed":if(this.waiting)return;this.analysed=e;break;case"Equations":this.equations=e;break;case"Light":if(this.waiting)return;this.lit=e;break;case"Board":this.board=e;break;case"JobResult":this.found=e;break;case"History":this.traces.fill(e.t,e.rows);break}for(const t of this.listeners)t(e)}changedTo(e){const t=this.changed?.bodies.join()===e.bodies.join(),n=this.changed!==null&&No(this.changed.setup)!==No(e.setup);this.changed=e,n&&!this.waiting&&this.forget(),this.waiting=!1,this.setup=e.setup,t||this.traces.reset(e.bodies.length)}}const te=new Xy;class tc{root;plot;constructor(e,t,n,s,r){const o=Er(),a=parseFloat(getComputedStyle(document.documentElement).fontSize)/16,l={stroke:o.soft,grid:{stroke:o.grid,width:1},ticks:{show:!1},font:`${11*a}px system-ui, sans-serif`},c=B("div",{className:"plot","aria-hidden":"true"});c.style.setProperty("--height",`${s/16}rem`),this.root=B("figure",{className:"strip",role:"group","aria-label":`${e} [${t}]`},B("figcaption",{},B("b",{},e),B("span",{},t)),c),this.plot=new mn({width:300,height:s,padding:[6,8,0,0],cursor:{show:!1},legend:{show:!1},scales:{x:{time:!1},y:{range:(u,h,d)=>Xf(h,d,r)}},axes:[{...l,size:20*a,values:(u,h)=>h.map(d=>d<0?"":Ns(`${+d.toFixed(1)} s`)),space:70*a},{...l,size:46*a,space:24*a,values:(u,h)=>h.map(d=>Ns(String(+d.toPrecision(4)).replace("-","−")))}],series:[{},...n.map(u=>({label:u.label,stroke:u.colour,width:(u.width??1.6)*a,dash:u.dash,points:{show:!1},spanGaps:!1}))]},[[],...n.map(()=>[])],c),new ResizeObserver(()=>this.fit(c)).observe(c)}fit(e){e.clientWidth>40&&this.plot.setSize({width:e.clientWidth,height:e.clientHeight})}show(e,t,n,s){this.plot.batch(()=>{this.plot.setData([e,...t],!1),this.plot.setScale("x",{min:n,max:s})})}}function Xf(i,e,t){if(!Number.isFinite(i)||!Number.isFinite(e))return[-t,t];const n=(i+e)/2,s=Math.max((e-i)/2*1.1,t);return[n-s,n+s]}const qy=[.05,.3,.5,1,.05,.2];class Yy{constructor(e){this.seconds=e}root=B("section",{className:"charts","aria-label":W("charts")});strips=[];legend=B("div",{className:"legend"});build(){const e=te.changed?.bodies??[],t=e.map(n=>({label:ai(n),colour:Ps(n),dash:au(n)}));this.strips=Oa.map((n,s)=>new tc(`${Ls[s]}  ${ai(n)}`,$f[s],t,104,qy[s])),xt(this.legend,...e.map(n=>qf(n))),xt(this.root,this.legend,B("div",{className:"strips"},...this.strips.map(n=>n.root)))}draw(){const{t:e,x:t}=te.traces;if(!e.length||t.length!==te.changed?.bodies.length)return;const n=te.snapshot?.back?te.snapshot.t:e.at(-1),s=n-this.seconds();let r=e.length;for(;r>0&&e[r-1]>=s;)r-=1;r=Math.max(0,r-1);const o=e.slice(r);this.strips.forEach((a,l)=>a.show(o,t.map(c=>c[l].slice(r)),s,n))}}function qf(i){const e=document.createElementNS("http://www.w3.org/2000/svg","svg");e.setAttribute("width","28"),e.setAttribute("height","10"),e.setAttribute("aria-hidden","true");const t=document.createElementNS("http://www.w3.org/2000/svg","line"),n={x1:"0",x2:"28",y1:"5",y2:"5",stroke:Ps(i),"stroke-width":"2.5","stroke-dasharray":au(i).join(" ")};for(const[r,o]of Object.entries(n))t.setAttribute(r,o);e.append(t);const s=i==="twin"?W("twinNote"):"";return B("span",{className:"key",title:s},e,ai(i))}function jy(i){const e=Object.entries(i).filter(([s,r])=>JSON.stringify(r)!==JSON.stringify(Fa[s]));if(!e.length)return"";const t=JSON.stringify(Object.fromEntries(e)),n=Array.from(new TextEncoder().encode(t),s=>String.fromCharCode(s)).join("");return"#setup="+btoa(n).replaceAll("+","-").replaceAll("/","_").replace(/=+$/,"")}function Yf(i){const e=/[#&]setup=([\w-]+)/.exec(i);if(!e)return null;try{const t=Uint8Array.from(atob(e[1].replaceAll("-","+").replaceAll("_","/")),s=>s.charCodeAt(0)),n=JSON.parse(new TextDecoder().decode(t));return{...Fa,...n}}catch{return null}}function Ky(i){return/[#&]token=([\w-]+)/.exec(i)?.[1]??""}let Zy=class{constructor(e,t){this.credentials=e,this.say=t,te.send=n=>this.send(n),this.open()}socket=null;wait=250;closed=!1;first=!0;send(e){this.socket?.readyState===WebSocket.OPEN&&this.socket.send(JSON.stringify(e))}open(){this.say(this.first?"connecting":"lost");const e=new URL("ws",document.baseURI);e.protocol=e.protocol.replace("http","ws"),e.hash="";const t=new WebSocket(e);this.socket=t,t.onopen=()=>this.greet(),t.onmessage=n=>this.hear(JSON.parse(n.data)),t.onclose=()=>this.lost()}greet(){const e=this.first?Yf(location.hash):null;this.send({kind:"Hello",version:Gy,session:e?"":sessionStorage.getItem("session")??"",token:this.credentials.token,name:this.credentials.name,setup:e??(te.changed?te.setup:null)})}hear(e){e.kind==="Snapshot"&&this.send({kind:"Ack",n:e.n}),e.kind==="Welcome"&&(sessionStorage.setItem("session",e.session),this.wait=250,this.first=!1,this.say("connected")),e.kind==="Refused"&&(this.closed=!0,this.say("refused",e.reason)),te.hear(e)}lost(){this.closed||(this.say("lost"),window.setTimeout(()=>this.open(),this.wait),this.wait=Math.min(this.wait*1.6,3e3))}};const Jy="http://www.w3.org/2000/svg",qr=420,$t={left:58,right:10,top:8,bottom:34};function ho(i){const e=i.square?qr*.82:190,t=Wn("svg",{viewBox:`0 0 ${qr} ${e}`,role:"img","aria-label":i.title,class:"drawing"}),n=v=>i.logX?Math.log10(v):v,[s,r]=[n(i.x[0]),n(i.x[1])],[o,a]=[qr-$t.left-$t.right,e-$t.top-$t.bottom],l=v=>$t.left+(n(v)-s)/(r-s)*o,c=v=>$t.top+(1-(v-i.y[0])/(i.y[1]-i.y[0]))*a,u=Er(),h=`clip-${Math.random().toString(36).slice(2)}`,d=Wn("clipPath",{id:h});d.append(Wn("rect",{x:$t.left,y:$t.top,width:o,height:a})),t.append(d);for(const v of i.logX?tb(i.x):kh(i.x,6))t.append(Wn("line",{x1:l(v),x2:l(v),y1:$t.top,y2:$t.top+a,stroke:u.grid})),t.append(Io(Bh(v),l(v),$t.top+a+14,"middle",u.soft));for(const v of kh(i.y,5))t.append(Wn("line",{x1:$t.left,x2:qr-$t.right,y1:c(v),y2:c(v),stroke:u.grid})),t.append(Io(Bh(v),$t.left-6,c(v)+4,"end",u.soft));t.append(Io(i.xLabel,$t.left+o/2,e-4,"middle",u.soft));const m=Io(i.yLabel,0,0,"middle",u.soft);m.setAttribute("transform",`translate(9 ${$t.top+a/2}) rotate(-90)`),t.append(m);const _=Wn("g",{"clip-path":`url(#${h})`});t.append(_),i.circle&&_.append(Wn("ellipse",{cx:l(0),cy:c(0),rx:l(1)-l(0),ry:c(0)-c(1),fill:"none",stroke:u.soft,"stroke-dasharray":"4 3"}));for(const v of i.marks??[]){const p=v.y===void 0?{x1:l(v.x??0),x2:l(v.x??0),y1:$t.top,y2:$t.top+a}:{y1:c(v.y),y2:c(v.y),x1:$t.left,x2:qr-$t.right};_.append(Wn("line",{...p,stroke:u.push,"stroke-width":1.2,"stroke-dasharray":"5 3"}))}for(const v of i.lines??[])_.append(Qy(v,l,c));for(const v of i.points??[])_.append(eb(v.cross??!1,l(v.x),c(v.y),v.colour));return t}function Wn(i,e={}){const t=document.createElementNS(Jy,i);for(const[n,s]of Object.entries(e))t.setAttribute(n,String(s));return t}function Io(i,e,t,n,s){const r=Wn("text",{x:e,y:t,"text-anchor":n,fill:s,"font-size":11.5});return r.textContent=i,r}function Qy(i,e,t){let n="",s=!1;return i.x.forEach((r,o)=>{const a=i.y[o],l=Number.isFinite(r)&&Number.isFinite(a);l&&(n+=`${s?"L":"M"}${e(r).toFixed(1)} ${t(a).toFixed(1)}`),s=l}),Wn("path",{d:n,fill:"none",stroke:i.colour,"stroke-width":1.8,"stroke-dasharray":(i.dash??[]).join(" "),"stroke-linejoin":"round"})}function eb(i,e,t,n){if(!i)return Wn("circle",{cx:e,cy:t,r:4,fill:n});const s=4.5;return Wn("path",{d:`M${e-s} ${t-s}L${e+s} ${t+s}M${e-s} ${t+s}L${e+s} ${t-s}`,stroke:n,"stroke-width":1.8})}function kh([i,e],t){const n=(e-i)/t,s=10**Math.floor(Math.log10(n)),r=[1,2,5,10].map(a=>a*s).find(a=>a>=n)??n,o=[];for(let a=Math.ceil(i/r)*r;a<=e+r*1e-6;a+=r)o.push(Math.abs(a)<r*1e-6?0:a);return o}function tb([i,e]){const t=[];for(let n=Math.ceil(Math.log10(i));10**n<=e;n+=1)t.push(10**n);return t}function Bh(i){return Ns(String(+i.toPrecision(6)).replace("-","−"))}const nb=["loop","portrait","voltages","estimate","equations"],Uo=8,ib=["ψ̇","ψ̈","θ̇","θ̈","φ̇","φ̈"];class sb{root=B("div",{className:"see"});view="loop";stage=B("div",{className:"stage"});strips=[];build(){const e=nb.map(n=>[n,W(n)]),t=Is(W("tabSee"),e,this.view,n=>{this.view=n,this.show()},"view");xt(this.root,t,this.stage),this.show()}show(){this.strips=[],this.view==="loop"?xt(this.stage,...this.loop()):this.view==="equations"?xt(this.stage,...lb()):this.view==="voltages"?this.voltages():this.view==="estimate"?this.estimate():this.portrait()}draw(){if(this.view==="portrait"&&this.portrait(),!this.strips.length)return;const e=te.traces,t=e.t.at(-1)??0;let n=e.t.length;for(;n>0&&e.t[n-1]>=t-Uo;)n-=1;const s=e.t.slice(n),r=o=>o.slice(n);if(this.view==="estimate")this.strips[0].show(s,[r(e.x[0]?.[0]??[]),r(e.estimate)],t-Uo,t);else{const o=[1,2].map((a,l)=>r(e.saturated).map((c,u)=>c&a?e.volts[l][n+u]:NaN));this.strips.forEach((a,l)=>a.show(s,[r(e.volts[l]),o[l]],t-Uo,t))}}voltages(){const{text:e,push:t}=Er(),n=te.changed?.look.command_unit??"V";this.strips=[W("leftMotor"),W("rightMotor")].map(r=>new tc(r,n,[{label:r,colour:e,dash:[]},{label:W("saturated"),colour:t,dash:[],width:5}],150,1));const s=B("p",{className:"note"},W(n==="V"?"voltagesNote":"torquesNote"));xt(this.stage,s,...this.strips.map(r=>r.root))}estimate(){if(!te.snapshot?.e.length){xt(this.stage,B("p",{className:"note"},W("noEstimate")));return}const{push:e}=Er(),t=[{label:W("truth"),colour:Ps(te.changed?.bodies[0]??"twin"),dash:[]},{label:W("opinion"),colour:e,dash:[4,3]}];this.strips=[new tc(`ψ: ${W("truth")} / ${W("opinion")}`,"rad",t,190,.02)],xt(this.stage,B("p",{className:"note"},W("estimateNote")),this.strips[0].root)}portrait(){const{t:e,x:t}=te.traces,n=(e.at(-1)??0)-Uo;let s=e.length;for(;s>0&&e[s-1]>=n;)s-=1;const r=(o,a)=>{const l=t.map((d,m)=>{const _=te.changed?.bodies[m]??"";return{x:d[o].slice(s),y:d[o+1].slice(s),colour:Ps(_),dash:au(_)}}),c=(d,m)=>{const _=l.flatMap(f=>f[d]),[v,p]=[_.reduce((f,E)=>Math.min(f,E),1/0),_.reduce((f,E)=>Math.max(f,E),-1/0)];return Xf(v,p,m)},u=l.map(d=>({x:d.x.at(-1)??0,y:d.y.at(-1)??0,colour:d.colour})),h=ai(Oa[o]);return Ma(h,ho({title:`${W("portrait")}: ${h}`,xLabel:`${Ls[o]} [rad]`,yLabel:`${Ls[o+1]} [rad/s]`,lines:l,points:u,x:c("x",a[0]),y:c("y",a[1]),square:!0}))};xt(this.stage,r(0,[.03,.4]),r(2,[.5,1]),r(4,[.05,.2]))}loop(){const e=te.analysed;if(!e)return[B("p",{className:"note"},W("designing"))];const t=B("p",{className:"note"},cu(Fn(e.words))),n=Ps("twin"),s=[t];return e.L.length===3&&s.push(...rb(e.L,n)),e.poles.length&&s.push(ob(e.poles,n)),s}}function rb([i,e,t],n){const s=i.map((h,d)=>20*Math.log10(Math.hypot(e[d],t[d]))),r=ab(i.map((h,d)=>Math.atan2(t[d],e[d])*180/Math.PI)),o=[i[0],i.at(-1)],a=(h,d)=>[Math.min(...h)-d,Math.max(...h)+d],l=[ho({title:W("bode"),xLabel:"ω [rad/s]",yLabel:"|L| [dB]",lines:[{x:i,y:s,colour:n}],x:o,y:a(s,3),logX:!0,marks:[{y:0}]}),ho({title:W("bode"),xLabel:"ω [rad/s]",yLabel:"∠L [°]",lines:[{x:i,y:r,colour:n}],x:o,y:a(r,8),logX:!0,marks:[{y:-180}]})],c=t.map(h=>-h),u=ho({title:W("nyquist"),xLabel:"Re L",yLabel:"Im L",square:!0,x:[-3.2,1.6],y:[-2,2],circle:!0,lines:[{x:e,y:t,colour:n},{x:e,y:c,colour:n,dash:[4,3]}],points:[{x:-1,y:0,colour:Er().push,cross:!0}]});return[Ma(W("bode"),...l),Ma(W("nyquist"),u)]}function ob(i,e){const t=i.map(([r,o])=>({x:r,y:o,colour:Math.hypot(r,o)>=1?Er().push:e,cross:!0})),n=Math.max(1.15,...i.map(([r,o])=>Math.max(Math.abs(r),Math.abs(o))*1.1)),s=n*1.2;return Ma(W("poles"),ho({title:W("poles"),xLabel:"Re z",yLabel:"Im z",points:t,x:[-s,s],y:[-n,n],square:!0,circle:!0}))}function cu(i){return i.charAt(0).toUpperCase()+i.slice(1)}function Ma(i,...e){return B("figure",{className:"titled","aria-label":i},B("figcaption",{},i),...e)}function ab(i){let e=0;return i.map((t,n)=>(n&&(e+=Math.round((i[n-1]-t)/360)*360),t+e)).map((t,n,s)=>t-Math.round((s[0]+180)/360)*360)}function lb(){const i=te.equations;if(!i)return[];const[e,,t,n]=i.inertias.map(p=>zt(p,4)),[s,r,o,a]=[i.alpha,i.beta,i.weight,i.lever].map(p=>zt(p,4)),[l,c]=[zt(i.swing,4),zt(i.half_track,4)],u=`(${a} cos ψ − ${zt(i.lever-i.inertias[1],3)})`,[h,d]=[`${s} (v_l + v_r)`,`2·${r} (θ̇ − ψ̇)`],m=[`${e} θ̈ + ${u} ψ̈ = ${h} − ${d} + ${a} (ψ̇² + φ̇²) sin ψ`,`${u} θ̈ + ${t} ψ̈ = −${h} + ${d} + (${o} + ${l} φ̇² cos ψ) sin ψ`,`(${n} + ${l} sin² ψ) φ̈ = ${c}·${s} (v_r − v_l) − 2·${c}²·${r} φ̇ − (2·${l} ψ̇ cos ψ + ${a} θ̇) φ̇ sin ψ`,`α = ${s}   β = ${r}   M g L = ${o} N m   M L R = ${a} kg m²   W/2R = ${c}`],_=(p,f)=>xa([p,...f[0].map((E,T)=>p==="A"?Ls[T]:["v_l","v_r"][T])],f.map((E,T)=>[ib[T],...E.map(M=>zt(M,4))]),"matrix"),v=i.poles.map(([p,f])=>zt(p,4)+(f?` ± ${zt(Math.abs(f),3)}j`:"")).join(";  ");return[B("pre",{className:"equations",tabIndex:0},m.join(`
`)),B("p",{className:"note"},W("equationsNote")),B("p",{},`${W("openPoles")}: ${v} 1/s`),B("h4",{},W("linearised")),_("A",i.A),_("B",i.B)]}const cb=Wf(120,i=>te.change(i));let al={};function _i(i){al={...al,...i},te.expect(i),cb(al)}class _o{root=B("div",{className:"panel-body"});update(){}}class ub extends _o{weights=B("div",{className:"sliders"});numbers=B("div",{className:"numbers"});light=B("div",{className:"light",role:"status"});sliders=[];shape="";build(){this.shape="";const e=(te.catalogue?.families??[]).map(s=>[s.name,ai(s.name)]),t=Is(W("family"),e,te.setup.controller,s=>{te.change({controller:s,gains:s==="gains"?this.present():te.setup.gains})},"controller"),n=_t(W("fullCertificate"),()=>te.send({kind:"Start",job:"certify",file:""}),{"data-key":"certify"});xt(this.root,B("div",{className:"column"},t,this.weights),B("div",{className:"column"},this.numbers),B("div",{className:"column"},this.light,n)),this.update()}present(){return te.analysed?.gain[0]?.slice(0,6)??[]}update(){const e=this.root.querySelector("[data-key=controller]");e&&document.activeElement!==e&&(e.value=te.setup.controller);const t=`${te.setup.controller} ${te.changed?.look.command_unit} ${this.byHand().length}`;t!==this.shape&&this.shapeWeights(t),this.sliders.forEach((n,s)=>n.set(te.setup.controller==="gains"?this.byHand()[s]??0:this.sizes()[s])),xt(this.numbers,...this.analysis()),xt(this.light,...jf())}byHand(){return te.setup.gains.length?te.setup.gains:this.present()}sizes(){const e=te.changed?.look.command_unit??"V",t=[...te.catalogue?.largest??[],te.catalogue?.command[e]??1];return te.setup.largest.length===t.length?te.setup.largest:t}shapeWeights(e){this.shape=e;const t=te.catalogue?.families.find(n=>n.name===te.setup.controller);if(this.sliders=[],te.setup.controller==="gains"){const n=this.byHand(),s=Math.max(...n.map(Math.abs),.1),r=o=>Math.max(4*Math.abs(n[o]??0),s/4);this.sliders=Ls.map((o,a)=>si(`${o} → u`,{low:-r(a),high:r(a),step:r(a)/500,show:l=>zt(l,4),key:`gain-${a}`},l=>{const c=[...this.byHand().length?this.byHand():[0,0,0,0,0,0]];c[a]=l,_i({gains:c})})),xt(this.weights,...this.sliders.map(o=>o.root))}else if(t?.weights){const n=[...te.catalogue?.largest??[],te.catalogue?.command[te.changed?.look.command_unit??"V"]??1];this.sliders=n.map((r,o)=>this.weight(r,o));const s=_t(W("ownWeights"),()=>te.change({largest:[]}),{className:"quiet","data-key":"own-weights"});xt(this.weights,B("p",{className:"note"},W("weights")),...this.sliders.map(r=>r.root),s)}else xt(this.weights,B("p",{className:"note"},W("noWeights")))}weight(e,t){const n=t<6?$f[t]:te.changed?.look.command_unit??"V",s=t<6?`${Ls[t]} ${ai(Oa[t])}`:W("command");return si(s,{low:e/10,high:e*10,log:!0,show:r=>`${zt(r,2)} ${n}`,key:`weight-${t}`},r=>{const o=[...this.sizes()];o[t]=r,_i({largest:o})})}analysis(){const e=te.analysed;if(!e)return[B("p",{className:"note"},te.setup.controller==="off"?W("off"):W("designing"))];const t=[];e.gain.length&&t.push(B("h4",{},W("gain")),xa(Ls,[e.gain[0].map(r=>zt(r,3))],"gains"));const n=(r,o)=>`${r===null?"0":zt(r,2)} … ${o===null?"∞":zt(o,3)}`,s=[[W("gainMargin"),n(e.gain_low,e.gain_high)],[W("phaseMargin"),e.phase===null?W("unlimited"):`${zt(e.phase*180/Math.PI,2)}°`],[W("delayMargin"),e.delay===null?W("unlimited"):`${zt(e.delay*1e3,3)} ms`]];return e.stable&&t.push(B("h4",{},W("margins")),xa([],s,"margins")),t.push(B("p",{className:"note"},cu(Fn(e.words)))),t}}function jf(){const i=te.lit,e=i?.light??"none",t=e==="none"&&i?.reasons.length?W("noCertificate"):W(e),n=B("span",{className:`lamp ${e}`,"aria-hidden":"true"});return[B("h4",{},W("certificate")),B("p",{className:"lit"},n,B("b",{},t)),...(i?.reasons??[]).map(s=>B("p",{className:"note"},cu(Fn(s))))]}class hb extends _o{sliders=[];table=B("div",{className:"parameters"});shown="";opened=!1;build(){this.shown="";const e=(te.catalogue?.robots??[]).map(s=>[s.name,s.name]);e.some(([s])=>s===te.setup.robot)||e.push([te.setup.robot,te.setup.robot]);const t=Is(W("preset"),e,te.setup.robot,s=>this.choose(s),"robot");this.sliders=[["payload",si(W("payload"),{low:0,high:this.weight(),step:.005,show:s=>`${zt(s*1e3,3)} g`,key:"payload"},s=>_i({payload:s}))],["payload_height",si(W("payloadHeight"),{low:0,high:.5,step:.005,show:s=>`${zt(s*100,3)} cm`,key:"payload_height"},s=>_i({payload_height:s}))],["slope",si(W("slope"),{low:-.2,high:.2,step:.005,show:s=>`${zt(s,2)} rad`,key:"slope"},s=>_i({slope:s}))],["grip",si(W("grip"),{low:.02,high:10,log:!0,show:s=>zt(s,2),key:"grip"},s=>_i({grip:s}))]];const n=B("details",{open:this.opened,ontoggle:()=>this.opened=n.open},B("summary",{},W("numbers")),B("p",{className:"note"},W("numbersNote")),this.table);xt(this.root,B("div",{className:"column"},t,B("p",{className:"note"},Fn(this.title())),Kf(W("openRobot"),".toml","robot")),B("div",{className:"column"},B("div",{className:"sliders"},...this.sliders.map(([,s])=>s.root))),B("div",{className:"column"},this.bodies()),B("div",{className:"column full"},n)),this.update()}weight(){return Math.max(.3,(te.changed?.look.weight??6)/9.81*.6)}title(){return te.catalogue?.robots.find(e=>e.name===te.setup.robot)?.title??""}choose(e){const t=te.catalogue?.robots.find(n=>n.name===e);t&&te.change({robot:e,numbers:{},drive:"",kit:t.kit,largest:[],gains:[],payload:0,delay:-1,voltage:-1,dead_zone:-1})}bodies(){const e=["twin","nonlinear","linear","published",...te.changed?.bodies.includes("calibrated")?["calibrated"]:[]],t=e.map(n=>{const s=br("body"),r=B("input",{type:"checkbox",id:s,checked:te.setup.bodies.includes(n),"data-key":`body-${n}`,onchange:()=>{const o=e.filter(a=>a===n?r.checked:te.setup.bodies.includes(a));o.length?te.change({bodies:o}):r.checked=!0}});return B("label",{for:s,className:"check"},r,qf(n))});return B("fieldset",{},B("legend",{},W("bodies")),...t)}update(){for(const[n,s]of this.sliders)s.set(te.setup[n]);const e=JSON.stringify([te.setup.robot,te.setup.numbers,te.changed?.bodies]);if(e===this.shown)return;const t=this.shown!=="";this.shown=e,t&&!this.root.contains(document.activeElement)&&this.build(),this.parameters()}parameters(){const t={...te.catalogue?.robots.find(s=>s.name===te.setup.robot)?.numbers??{},...te.setup.numbers},n=Object.entries(t).map(([s,r])=>{const o=br("number"),a=B("input",{type:"number",id:o,step:"any",value:String(r),"data-key":`number-${s}`,onchange:()=>{Number.isFinite(a.valueAsNumber)&&te.change({numbers:{...te.setup.numbers,[s]:a.valueAsNumber}})}}),l=te.catalogue?.symbols[s]??"";return B("div",{className:"parameter"},B("label",{for:o},`${Fn(s.replaceAll("_"," "))} ${l}`),a,B("span",{},(te.catalogue?.units[s]??"").replace(/^1$/,"")))});xt(this.table,...n,_t(W("ownNumbers"),()=>te.change({numbers:{},drive:""}),{className:"quiet","data-key":"own-numbers"}))}}class db extends _o{sliders=[];build(){const e=(te.catalogue?.kits??[]).map(r=>[r,r==="ideal"?W("ideal"):r]),t=Is(W("kit"),e,te.setup.kit,r=>te.change({kit:r,delay:-1,voltage:-1,dead_zone:-1,noise:1}),"kit"),n=te.changed?.look.command_unit??"V";this.sliders=[["noise",si(W("noise"),{low:0,high:10,step:.1,show:r=>`× ${zt(r,2)}`,key:"noise"},r=>_i({noise:r}))],["delay",si(W("delay"),{low:0,high:.04,step:.002,show:r=>`${zt(r*1e3,2)} ms`,key:"delay"},r=>_i({delay:r}))],["voltage",si(W("voltage"),{low:1,high:14,step:.1,show:r=>r>0?`${zt(r,3)} V`:W("unlimited"),key:"voltage"},r=>_i({voltage:r}))],["dead_zone",si(W("deadZone"),{low:0,high:n==="V"?2:.1,show:r=>`${zt(r,2)} ${n}`,key:"dead_zone"},r=>_i({dead_zone:r}))]];const s=_t(W("ownKit"),()=>te.change({noise:1,delay:-1,voltage:-1,dead_zone:-1}),{className:"quiet","data-key":"own-kit"});xt(this.root,B("div",{className:"column"},t,s),B("div",{className:"column wide"},B("div",{className:"sliders"},...this.sliders.map(([,r])=>r.root)))),this.update()}update(){const e=te.changed?.kit??{};for(const[n,s]of this.sliders)s.set(n==="noise"?te.setup.noise:e[n]);const t=this.root.querySelector("[data-key=kit]");t&&document.activeElement!==t&&(t.value=te.setup.kit)}}function Kf(i,e,t){const n=br("file"),s=B("input",{type:"file",id:n,accept:e,className:"file","data-key":`open-${t}`,onchange:()=>{const r=s.files?.[0];s.value="",r&&fb(r,t)}});return B("div",{className:"upload"},s,B("label",{for:n,className:"button"},i))}let Es="";async function fb(i,e){const t=`upload/${te.session}?what=${e}&name=${encodeURIComponent(i.name)}`;te.hear({kind:"Notice",level:"info",text:W("uploaded",{name:i.name}),key:""});try{const s=await(await fetch(t,{method:"POST",body:i})).json();s.error?te.hear({kind:"Notice",level:"error",text:s.error,key:""}):e==="log"&&(Es=s.name??"")}catch{te.hear({kind:"Notice",level:"error",text:W("lost"),key:""})}}class pb extends _o{bars=B("div",{className:"bars"});result=B("div",{className:"result",role:"region","aria-live":"polite"});shares=new Map;source="";build(){const e=[["",W("thisRun")]];Es&&e.push([Es,Es.replace(/^in-/,"")]),Es&&(this.source=Es);const t=Is(W("source"),e,this.source,o=>this.source=o,"source"),n=o=>te.send({kind:"Start",job:o,file:this.source}),s=B("div",{className:"row"},_t(W("doctor"),()=>n("doctor"),{title:W("doctorTip"),"data-key":"doctor"}),_t(W("calibrate"),()=>n("calibrate"),{title:W("calibrateTip"),"data-key":"calibrate"}),_t(W("compare"),()=>te.send({kind:"Save",what:"report",name:this.source}),{title:W("compareTip"),"data-key":"compare"}));xt(this.root,B("div",{className:"column"},t,Kf(W("openLog"),".csv,.txt,.log,.tsv,.dat,.json,.mat,.parquet,.mcap","log"),s,B("p",{className:"note"},W("calibrateNote")),this.bars),B("div",{className:"column wide"},this.result)),this.found()}progress(e,t){t>=1?this.shares.delete(e):this.shares.set(e,t);const n=[...this.shares].filter(([s])=>s!=="design").map(([s,r])=>B("div",{className:"bar"},B("span",{},ai(s)),B("progress",{max:1,value:r,"aria-label":ai(s)}),_t(W("stop"),()=>te.send({kind:"Cancel",job:s}),{"data-key":`stop-${s}`})));xt(this.bars,...n)}found(){const e=te.found;if(!e)return;const n=e.text.split(`
`).filter(Boolean).map(r=>B("p",{className:"note",lang:Gf(r)?"":"en"},Fn(r))),s=r=>r.map(o=>Fn(e.job==="calibrate"?o.replaceAll("_"," "):o));xt(this.result,B("h4",{},Fn(e.title)),...n,e.rows.length?xa(e.header.map(Fn),e.rows.map(s)):null)}}class mb extends _o{constructor(e){super(),this.picture=e}links=B("div",{className:"links",role:"status"});build(){const t=[["csv",W("csv")],["parquet",W("parquet")],["report",W("report")],["replay",W("replay")],["controller",W("controllerFile")],["robot",W("robotFile")]].map(([r,o])=>_t(o,()=>te.send({kind:"Save",what:r,name:""}),{"data-key":`keep-${r}`})),n=_t(W("picture"),()=>void this.photograph(),{"data-key":"picture"}),s=_t(W("link"),()=>void this.copy(),{"data-key":"link"});xt(this.root,B("div",{className:"column wide"},B("p",{className:"note"},W("keepNote")),B("div",{className:"row"},...t,n,s),B("p",{className:"note"},W("handInNote")),this.handIn(),this.links))}handIn(){const e=br("student"),t=B("input",{type:"text",id:e,maxLength:40,autocomplete:"name",value:sessionStorage.getItem("name")??"","data-key":"student"}),n=()=>{t.value.trim()?te.send({kind:"Save",what:"handin",name:t.value.trim()}):t.focus()};return B("div",{className:"row hand-in"},B("label",{for:e},W("yourName")),t,_t(W("handIn"),n,{"data-key":"keep-handin"}))}async photograph(){const e=await this.picture();e&&this.made(e.type.includes("svg")?"upright.svg":"upright.png",URL.createObjectURL(e))}async copy(){const e=location.href.split("#")[0]+jy(te.setup);history.replaceState(null,"",e),await navigator.clipboard?.writeText(e).catch(()=>{});const t=B("input",{readOnly:!0,value:e,"aria-label":W("link"),className:"address"});this.links.prepend(B("p",{className:"note"},W("linkCopied"),t)),t.select()}made(e,t){const n=B("a",{href:t,download:e},W("made",{name:e}));this.links.prepend(B("p",{},n)),n.click()}}class zh{moments;at=0;paused=!1;speed=1;clock=performance.now();constructor(e){this.moments=e.filter(t=>t.kind==="Snapshot"),te.replaying=!0,te.send=t=>this.act(t);for(const t of e)t.kind!=="Snapshot"&&te.hear(t);window.setInterval(()=>this.tick(),20)}static inPage(){const e=document.getElementById("recording");return e?JSON.parse(e.textContent??"[]"):null}tick(){const e=performance.now();!this.paused&&this.moments.length&&(this.at+=(e-this.clock)/1e3*this.speed,this.at>this.length()&&this.rewind(),this.show()),this.clock=e}length(){return(this.moments.at(-1)?.t??0)-(this.moments[0]?.t??0)}rewind(){this.at=0,te.traces.reset(this.moments[0].x.length)}show(){const e=this.moments[0].t+this.at,t=te.traces.t.at(-1)??-1/0;e<t&&te.traces.until(e);const n=this.moments.filter(r=>r.t>t&&r.t<=e),s=n.at(-1)??this.moments.findLast(r=>r.t<=e);for(const r of n.slice(0,-1))te.traces.add(r);s&&te.hear({...s,paused:this.paused,back:0})}act(e){if(e.kind==="Play")this.paused=e.paused,this.speed=e.speed;else if(e.kind==="Scrub")this.paused=!0,this.at=Math.max(0,this.length()-e.back);else if(e.kind==="Step")this.paused=!0,this.at+=.02*e.periods;else if(e.kind==="StandUp")this.rewind();else return;this.show()}}/**
 * @license
 * Copyright 2010-2024 Three.js Authors
 * SPDX-License-Identifier: MIT
 */const uu="170",gb=0,Hh=1,_b=2,Zf=1,Jf=2,Di=3,rs=0,An=1,Ni=2,ns=0,gr=1,Vh=2,Gh=3,Wh=4,vb=5,ws=100,xb=101,Mb=102,Sb=103,yb=104,bb=200,Eb=201,wb=202,Tb=203,nc=204,ic=205,Ab=206,Rb=207,Cb=208,Pb=209,Lb=210,Db=211,Nb=212,Ib=213,Ub=214,sc=0,rc=1,oc=2,wr=3,ac=4,lc=5,cc=6,uc=7,Qf=0,Fb=1,Ob=2,is=0,kb=1,Bb=2,zb=3,Hb=4,Vb=5,Gb=6,Wb=7,ep=300,Tr=301,Ar=302,hc=303,dc=304,ka=306,Sa=1e3,As=1001,fc=1002,oi=1003,$b=1004,Fo=1005,vi=1006,ll=1007,Rs=1008,Bi=1009,tp=1010,np=1011,po=1012,hu=1013,Us=1014,Ii=1015,vo=1016,du=1017,fu=1018,Rr=1020,ip=35902,sp=1021,rp=1022,ri=1023,op=1024,ap=1025,_r=1026,Cr=1027,lp=1028,pu=1029,cp=1030,mu=1031,gu=1033,ca=33776,ua=33777,ha=33778,da=33779,pc=35840,mc=35841,gc=35842,_c=35843,vc=36196,xc=37492,Mc=37496,Sc=37808,yc=37809,bc=37810,Ec=37811,wc=37812,Tc=37813,Ac=37814,Rc=37815,Cc=37816,Pc=37817,Lc=37818,Dc=37819,Nc=37820,Ic=37821,fa=36492,Uc=36494,Fc=36495,up=36283,Oc=36284,kc=36285,Bc=36286,Xb=3200,qb=3201,hp=0,Yb=1,es="",Un="srgb",Ur="srgb-linear",Ba="linear",At="srgb",Js=7680,$h=519,jb=512,Kb=513,Zb=514,dp=515,Jb=516,Qb=517,eE=518,tE=519,Xh=35044,qh="300 es",Ui=2e3,ya=2001;class Fr{addEventListener(e,t){this._listeners===void 0&&(this._listeners={});const n=this._listeners;n[e]===void 0&&(n[e]=[]),n[e].indexOf(t)===-1&&n[e].push(t)}hasEventListener(e,t){if(this._listeners===void 0)return!1;const n=this._listeners;return n[e]!==void 0&&n[e].indexOf(t)!==-1}removeEventListener(e,t){if(this._listeners===void 0)return;const s=this._listeners[e];if(s!==void 0){const r=s.indexOf(t);r!==-1&&s.splice(r,1)}}dispatchEvent(e){if(this._listeners===void 0)return;const n=this._listeners[e.type];if(n!==void 0){e.target=this;const s=n.slice(0);for(let r=0,o=s.length;r<o;r++)s[r].call(this,e);e.target=null}}}const dn=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"],cl=Math.PI/180,zc=180/Math.PI;function xo(){const i=Math.random()*4294967295|0,e=Math.random()*4294967295|0,t=Math.random()*4294967295|0,n=Math.random()*4294967295|0;return(dn[i&255]+dn[i>>8&255]+dn[i>>16&255]+dn[i>>24&255]+"-"+dn[e&255]+dn[e>>8&255]+"-"+dn[e>>16&15|64]+dn[e>>24&255]+"-"+dn[t&63|128]+dn[t>>8&255]+"-"+dn[t>>16&255]+dn[t>>24&255]+dn[n&255]+dn[n>>8&255]+dn[n>>16&255]+dn[n>>24&255]).toLowerCase()}function Tn(i,e,t){return Math.max(e,Math.min(t,i))}function nE(i,e){return(i%e+e)%e}function ul(i,e,t){return(1-t)*i+t*e}function Yr(i,e){switch(e.constructor){case Float32Array:return i;case Uint32Array:return i/4294967295;case Uint16Array:return i/65535;case Uint8Array:return i/255;case Int32Array:return Math.max(i/2147483647,-1);case Int16Array:return Math.max(i/32767,-1);case Int8Array:return Math.max(i/127,-1);default:throw new Error("Invalid component type.")}}function wn(i,e){switch(e.constructor){case Float32Array:return i;case Uint32Array:return Math.round(i*4294967295);case Uint16Array:return Math.round(i*65535);case Uint8Array:return Math.round(i*255);case Int32Array:return Math.round(i*2147483647);case Int16Array:return Math.round(i*32767);case Int8Array:return Math.round(i*127);default:throw new Error("Invalid component type.")}}class mt{constructor(e=0,t=0){mt.prototype.isVector2=!0,this.x=e,this.y=t}get width(){return this.x}set width(e){this.x=e}get height(){return this.y}set height(e){this.y=e}set(e,t){return this.x=e,this.y=t,this}setScalar(e){return this.x=e,this.y=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;default:throw new Error("index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;default:throw new Error("index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y)}copy(e){return this.x=e.x,this.y=e.y,this}add(e){return this.x+=e.x,this.y+=e.y,this}addScalar(e){return this.x+=e,this.y+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this}subScalar(e){return this.x-=e,this.y-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this}multiply(e){return this.x*=e.x,this.y*=e.y,this}multiplyScalar(e){return this.x*=e,this.y*=e,this}divide(e){return this.x/=e.x,this.y/=e.y,this}divideScalar(e){return this.multiplyScalar(1/e)}applyMatrix3(e){const t=this.x,n=this.y,s=e.elements;return this.x=s[0]*t+s[3]*n+s[6],this.y=s[1]*t+s[4]*n+s[7],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this}clamp(e,t){return this.x=Math.max(e.x,Math.min(t.x,this.x)),this.y=Math.max(e.y,Math.min(t.y,this.y)),this}clampScalar(e,t){return this.x=Math.max(e,Math.min(t,this.x)),this.y=Math.max(e,Math.min(t,this.y)),this}clampLength(e,t){const n=this.length();return this.divideScalar(n||1).multiplyScalar(Math.max(e,Math.min(t,n)))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(e){return this.x*e.x+this.y*e.y}cross(e){return this.x*e.y-this.y*e.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(e){const t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;const n=this.dot(e)/t;return Math.acos(Tn(n,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){const t=this.x-e.x,n=this.y-e.y;return t*t+n*n}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this}lerpVectors(e,t,n){return this.x=e.x+(t.x-e.x)*n,this.y=e.y+(t.y-e.y)*n,this}equals(e){return e.x===this.x&&e.y===this.y}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this}rotateAround(e,t){const n=Math.cos(t),s=Math.sin(t),r=this.x-e.x,o=this.y-e.y;return this.x=r*n-o*s+e.x,this.y=r*s+o*n+e.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}}class et{constructor(e,t,n,s,r,o,a,l,c){et.prototype.isMatrix3=!0,this.elements=[1,0,0,0,1,0,0,0,1],e!==void 0&&this.set(e,t,n,s,r,o,a,l,c)}set(e,t,n,s,r,o,a,l,c){const u=this.elements;return u[0]=e,u[1]=s,u[2]=a,u[3]=t,u[4]=r,u[5]=l,u[6]=n,u[7]=o,u[8]=c,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(e){const t=this.elements,n=e.elements;return t[0]=n[0],t[1]=n[1],t[2]=n[2],t[3]=n[3],t[4]=n[4],t[5]=n[5],t[6]=n[6],t[7]=n[7],t[8]=n[8],this}extractBasis(e,t,n){return e.setFromMatrix3Column(this,0),t.setFromMatrix3Column(this,1),n.setFromMatrix3Column(this,2),this}setFromMatrix4(e){const t=e.elements;return this.set(t[0],t[4],t[8],t[1],t[5],t[9],t[2],t[6],t[10]),this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){const n=e.elements,s=t.elements,r=this.elements,o=n[0],a=n[3],l=n[6],c=n[1],u=n[4],h=n[7],d=n[2],m=n[5],_=n[8],v=s[0],p=s[3],f=s[6],E=s[1],T=s[4],M=s[7],k=s[2],L=s[5],D=s[8];return r[0]=o*v+a*E+l*k,r[3]=o*p+a*T+l*L,r[6]=o*f+a*M+l*D,r[1]=c*v+u*E+h*k,r[4]=c*p+u*T+h*L,r[7]=c*f+u*M+h*D,r[2]=d*v+m*E+_*k,r[5]=d*p+m*T+_*L,r[8]=d*f+m*M+_*D,this}multiplyScalar(e){const t=this.elements;return t[0]*=e,t[3]*=e,t[6]*=e,t[1]*=e,t[4]*=e,t[7]*=e,t[2]*=e,t[5]*=e,t[8]*=e,this}determinant(){const e=this.elements,t=e[0],n=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],u=e[8];return t*o*u-t*a*c-n*r*u+n*a*l+s*r*c-s*o*l}invert(){const e=this.elements,t=e[0],n=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],u=e[8],h=u*o-a*c,d=a*l-u*r,m=c*r-o*l,_=t*h+n*d+s*m;if(_===0)return this.set(0,0,0,0,0,0,0,0,0);const v=1/_;return e[0]=h*v,e[1]=(s*c-u*n)*v,e[2]=(a*n-s*o)*v,e[3]=d*v,e[4]=(u*t-s*l)*v,e[5]=(s*r-a*t)*v,e[6]=m*v,e[7]=(n*l-c*t)*v,e[8]=(o*t-n*r)*v,this}transpose(){let e;const t=this.elements;return e=t[1],t[1]=t[3],t[3]=e,e=t[2],t[2]=t[6],t[6]=e,e=t[5],t[5]=t[7],t[7]=e,this}getNormalMatrix(e){return this.setFromMatrix4(e).invert().transpose()}transposeIntoArray(e){const t=this.elements;return e[0]=t[0],e[1]=t[3],e[2]=t[6],e[3]=t[1],e[4]=t[4],e[5]=t[7],e[6]=t[2],e[7]=t[5],e[8]=t[8],this}setUvTransform(e,t,n,s,r,o,a){const l=Math.cos(r),c=Math.sin(r);return this.set(n*l,n*c,-n*(l*o+c*a)+o+e,-s*c,s*l,-s*(-c*o+l*a)+a+t,0,0,1),this}scale(e,t){return this.premultiply(hl.makeScale(e,t)),this}rotate(e){return this.premultiply(hl.makeRotation(-e)),this}translate(e,t){return this.premultiply(hl.makeTranslation(e,t)),this}makeTranslation(e,t){return e.isVector2?this.set(1,0,e.x,0,1,e.y,0,0,1):this.set(1,0,e,0,1,t,0,0,1),this}makeRotation(e){const t=Math.cos(e),n=Math.sin(e);return this.set(t,-n,0,n,t,0,0,0,1),this}makeScale(e,t){return this.set(e,0,0,0,t,0,0,0,1),this}equals(e){const t=this.elements,n=e.elements;for(let s=0;s<9;s++)if(t[s]!==n[s])return!1;return!0}fromArray(e,t=0){for(let n=0;n<9;n++)this.elements[n]=e[n+t];return this}toArray(e=[],t=0){const n=this.elements;return e[t]=n[0],e[t+1]=n[1],e[t+2]=n[2],e[t+3]=n[3],e[t+4]=n[4],e[t+5]=n[5],e[t+6]=n[6],e[t+7]=n[7],e[t+8]=n[8],e}clone(){return new this.constructor().fromArray(this.elements)}}const hl=new et;function fp(i){for(let e=i.length-1;e>=0;--e)if(i[e]>=65535)return!0;return!1}function ba(i){return document.createElementNS("http://www.w3.org/1999/xhtml",i)}function iE(){const i=ba("canvas");return i.style.display="block",i}const Yh={};function ro(i){i in Yh||(Yh[i]=!0,console.warn(i))}function sE(i,e,t){return new Promise(function(n,s){function r(){switch(i.clientWaitSync(e,i.SYNC_FLUSH_COMMANDS_BIT,0)){case i.WAIT_FAILED:s();break;case i.TIMEOUT_EXPIRED:setTimeout(r,t);break;default:n()}}setTimeout(r,t)})}function rE(i){const e=i.elements;e[2]=.5*e[2]+.5*e[3],e[6]=.5*e[6]+.5*e[7],e[10]=.5*e[10]+.5*e[11],e[14]=.5*e[14]+.5*e[15]}function oE(i){const e=i.elements;e[11]===-1?(e[10]=-e[10]-1,e[14]=-e[14]):(e[10]=-e[10],e[14]=-e[14]+1)}const pt={enabled:!0,workingColorSpace:Ur,spaces:{},convert:function(i,e,t){return this.enabled===!1||e===t||!e||!t||(this.spaces[e].transfer===At&&(i.r=ki(i.r),i.g=ki(i.g),i.b=ki(i.b)),this.spaces[e].primaries!==this.spaces[t].primaries&&(i.applyMatrix3(this.spaces[e].toXYZ),i.applyMatrix3(this.spaces[t].fromXYZ)),this.spaces[t].transfer===At&&(i.r=vr(i.r),i.g=vr(i.g),i.b=vr(i.b))),i},fromWorkingColorSpace:function(i,e){return this.convert(i,this.workingColorSpace,e)},toWorkingColorSpace:function(i,e){return this.convert(i,e,this.workingColorSpace)},getPrimaries:function(i){return this.spaces[i].primaries},getTransfer:function(i){return i===es?Ba:this.spaces[i].transfer},getLuminanceCoefficients:function(i,e=this.workingColorSpace){return i.fromArray(this.spaces[e].luminanceCoefficients)},define:function(i){Object.assign(this.spaces,i)},_getMatrix:function(i,e,t){return i.copy(this.spaces[e].toXYZ).multiply(this.spaces[t].fromXYZ)},_getDrawingBufferColorSpace:function(i){return this.spaces[i].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(i=this.workingColorSpace){return this.spaces[i].workingColorSpaceConfig.unpackColorSpace}};function ki(i){return i<.04045?i*.0773993808:Math.pow(i*.9478672986+.0521327014,2.4)}function vr(i){return i<.0031308?i*12.92:1.055*Math.pow(i,.41666)-.055}const jh=[.64,.33,.3,.6,.15,.06],Kh=[.2126,.7152,.0722],Zh=[.3127,.329],Jh=new et().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),Qh=new et().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);pt.define({[Ur]:{primaries:jh,whitePoint:Zh,transfer:Ba,toXYZ:Jh,fromXYZ:Qh,luminanceCoefficients:Kh,workingColorSpaceConfig:{unpackColorSpace:Un},outputColorSpaceConfig:{drawingBufferColorSpace:Un}},[Un]:{primaries:jh,whitePoint:Zh,transfer:At,toXYZ:Jh,fromXYZ:Qh,luminanceCoefficients:Kh,outputColorSpaceConfig:{drawingBufferColorSpace:Un}}});let Qs;class aE{static getDataURL(e){if(/^data:/i.test(e.src)||typeof HTMLCanvasElement>"u")return e.src;let t;if(e instanceof HTMLCanvasElement)t=e;else{Qs===void 0&&(Qs=ba("canvas")),Qs.width=e.width,Qs.height=e.height;const n=Qs.getContext("2d");e instanceof ImageData?n.putImageData(e,0,0):n.drawImage(e,0,0,e.width,e.height),t=Qs}return t.width>2048||t.height>2048?(console.warn("THREE.ImageUtils.getDataURL: Image converted to jpg for performance reasons",e),t.toDataURL("image/jpeg",.6)):t.toDataURL("image/png")}static sRGBToLinear(e){if(typeof HTMLImageElement<"u"&&e instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&e instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&e instanceof ImageBitmap){const t=ba("canvas");t.width=e.width,t.height=e.height;const n=t.getContext("2d");n.drawImage(e,0,0,e.width,e.height);const s=n.getImageData(0,0,e.width,e.height),r=s.data;for(let o=0;o<r.length;o++)r[o]=ki(r[o]/255)*255;return n.putImageData(s,0,0),t}else if(e.data){const t=e.data.slice(0);for(let n=0;n<t.length;n++)t instanceof Uint8Array||t instanceof Uint8ClampedArray?t[n]=Math.floor(ki(t[n]/255)*255):t[n]=ki(t[n]);return{data:t,width:e.width,height:e.height}}else return console.warn("THREE.ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),e}}let lE=0;class pp{constructor(e=null){this.isSource=!0,Object.defineProperty(this,"id",{value:lE++}),this.uuid=xo(),this.data=e,this.dataReady=!0,this.version=0}set needsUpdate(e){e===!0&&this.version++}toJSON(e){const t=e===void 0||typeof e=="string";if(!t&&e.images[this.uuid]!==void 0)return e.images[this.uuid];const n={uuid:this.uuid,url:""},s=this.data;if(s!==null){let r;if(Array.isArray(s)){r=[];for(let o=0,a=s.length;o<a;o++)s[o].isDataTexture?r.push(dl(s[o].image)):r.push(dl(s[o]))}else r=dl(s);n.url=r}return t||(e.images[this.uuid]=n),n}}function dl(i){return typeof HTMLImageElement<"u"&&i instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&i instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&i instanceof ImageBitmap?aE.getDataURL(i):i.data?{data:Array.from(i.data),width:i.width,height:i.height,type:i.data.constructor.name}:(console.warn("THREE.Texture: Unable to serialize Texture."),{})}let cE=0;class yn extends Fr{constructor(e=yn.DEFAULT_IMAGE,t=yn.DEFAULT_MAPPING,n=As,s=As,r=vi,o=Rs,a=ri,l=Bi,c=yn.DEFAULT_ANISOTROPY,u=es){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:cE++}),this.uuid=xo(),this.name="",this.source=new pp(e),this.mipmaps=[],this.mapping=t,this.channel=0,this.wrapS=n,this.wrapT=s,this.magFilter=r,this.minFilter=o,this.anisotropy=c,this.format=a,this.internalFormat=null,this.type=l,this.offset=new mt(0,0),this.repeat=new mt(1,1),this.center=new mt(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new et,this.generateMipmaps=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=u,this.userData={},this.version=0,this.onUpdate=null,this.isRenderTargetTexture=!1,this.pmremVersion=0}get image(){return this.source.data}set image(e=null){this.source.data=e}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}clone(){return new this.constructor().copy(this)}copy(e){return this.name=e.name,this.source=e.source,this.mipmaps=e.mipmaps.slice(0),this.mapping=e.mapping,this.channel=e.channel,this.wrapS=e.wrapS,this.wrapT=e.wrapT,this.magFilter=e.magFilter,this.minFilter=e.minFilter,this.anisotropy=e.anisotropy,this.format=e.format,this.internalFormat=e.internalFormat,this.type=e.type,this.offset.copy(e.offset),this.repeat.copy(e.repeat),this.center.copy(e.center),this.rotation=e.rotation,this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrix.copy(e.matrix),this.generateMipmaps=e.generateMipmaps,this.premultiplyAlpha=e.premultiplyAlpha,this.flipY=e.flipY,this.unpackAlignment=e.unpackAlignment,this.colorSpace=e.colorSpace,this.userData=JSON.parse(JSON.stringify(e.userData)),this.needsUpdate=!0,this}toJSON(e){const t=e===void 0||typeof e=="string";if(!t&&e.textures[this.uuid]!==void 0)return e.textures[this.uuid];const n={metadata:{version:4.6,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(e).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(n.userData=this.userData),t||(e.textures[this.uuid]=n),n}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(e){if(this.mapping!==ep)return e;if(e.applyMatrix3(this.matrix),e.x<0||e.x>1)switch(this.wrapS){case Sa:e.x=e.x-Math.floor(e.x);break;case As:e.x=e.x<0?0:1;break;case fc:Math.abs(Math.floor(e.x)%2)===1?e.x=Math.ceil(e.x)-e.x:e.x=e.x-Math.floor(e.x);break}if(e.y<0||e.y>1)switch(this.wrapT){case Sa:e.y=e.y-Math.floor(e.y);break;case As:e.y=e.y<0?0:1;break;case fc:Math.abs(Math.floor(e.y)%2)===1?e.y=Math.ceil(e.y)-e.y:e.y=e.y-Math.floor(e.y);break}return this.flipY&&(e.y=1-e.y),e}set needsUpdate(e){e===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(e){e===!0&&this.pmremVersion++}}yn.DEFAULT_IMAGE=null;yn.DEFAULT_MAPPING=ep;yn.DEFAULT_ANISOTROPY=1;class Gt{constructor(e=0,t=0,n=0,s=1){Gt.prototype.isVector4=!0,this.x=e,this.y=t,this.z=n,this.w=s}get width(){return this.z}set width(e){this.z=e}get height(){return this.w}set height(e){this.w=e}set(e,t,n,s){return this.x=e,this.y=t,this.z=n,this.w=s,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this.w=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setW(e){return this.w=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;case 3:this.w=t;break;default:throw new Error("index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this.w=e.w!==void 0?e.w:1,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this.w+=e.w,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this.w+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this.w=e.w+t.w,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this.w+=e.w*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this.w-=e.w,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this.w-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this.w=e.w-t.w,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this.w*=e.w,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this.w*=e,this}applyMatrix4(e){const t=this.x,n=this.y,s=this.z,r=this.w,o=e.elements;return this.x=o[0]*t+o[4]*n+o[8]*s+o[12]*r,this.y=o[1]*t+o[5]*n+o[9]*s+o[13]*r,this.z=o[2]*t+o[6]*n+o[10]*s+o[14]*r,this.w=o[3]*t+o[7]*n+o[11]*s+o[15]*r,this}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this.w/=e.w,this}divideScalar(e){return this.multiplyScalar(1/e)}setAxisAngleFromQuaternion(e){this.w=2*Math.acos(e.w);const t=Math.sqrt(1-e.w*e.w);return t<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=e.x/t,this.y=e.y/t,this.z=e.z/t),this}setAxisAngleFromRotationMatrix(e){let t,n,s,r;const l=e.elements,c=l[0],u=l[4],h=l[8],d=l[1],m=l[5],_=l[9],v=l[2],p=l[6],f=l[10];if(Math.abs(u-d)<.01&&Math.abs(h-v)<.01&&Math.abs(_-p)<.01){if(Math.abs(u+d)<.1&&Math.abs(h+v)<.1&&Math.abs(_+p)<.1&&Math.abs(c+m+f-3)<.1)return this.set(1,0,0,0),this;t=Math.PI;const T=(c+1)/2,M=(m+1)/2,k=(f+1)/2,L=(u+d)/4,D=(h+v)/4,N=(_+p)/4;return T>M&&T>k?T<.01?(n=0,s=.707106781,r=.707106781):(n=Math.sqrt(T),s=L/n,r=D/n):M>k?M<.01?(n=.707106781,s=0,r=.707106781):(s=Math.sqrt(M),n=L/s,r=N/s):k<.01?(n=.707106781,s=.707106781,r=0):(r=Math.sqrt(k),n=D/r,s=N/r),this.set(n,s,r,t),this}let E=Math.sqrt((p-_)*(p-_)+(h-v)*(h-v)+(d-u)*(d-u));return Math.abs(E)<.001&&(E=1),this.x=(p-_)/E,this.y=(h-v)/E,this.z=(d-u)/E,this.w=Math.acos((c+m+f-1)/2),this}setFromMatrixPosition(e){const t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this.w=t[15],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this.w=Math.min(this.w,e.w),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this.w=Math.max(this.w,e.w),this}clamp(e,t){return this.x=Math.max(e.x,Math.min(t.x,this.x)),this.y=Math.max(e.y,Math.min(t.y,this.y)),this.z=Math.max(e.z,Math.min(t.z,this.z)),this.w=Math.max(e.w,Math.min(t.w,this.w)),this}clampScalar(e,t){return this.x=Math.max(e,Math.min(t,this.x)),this.y=Math.max(e,Math.min(t,this.y)),this.z=Math.max(e,Math.min(t,this.z)),this.w=Math.max(e,Math.min(t,this.w)),this}clampLength(e,t){const n=this.length();return this.divideScalar(n||1).multiplyScalar(Math.max(e,Math.min(t,n)))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z+this.w*e.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this.w+=(e.w-this.w)*t,this}lerpVectors(e,t,n){return this.x=e.x+(t.x-e.x)*n,this.y=e.y+(t.y-e.y)*n,this.z=e.z+(t.z-e.z)*n,this.w=e.w+(t.w-e.w)*n,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z&&e.w===this.w}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this.w=e[t+3],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e[t+3]=this.w,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this.w=e.getW(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}}class uE extends Fr{constructor(e=1,t=1,n={}){super(),this.isRenderTarget=!0,this.width=e,this.height=t,this.depth=1,this.scissor=new Gt(0,0,e,t),this.scissorTest=!1,this.viewport=new Gt(0,0,e,t);const s={width:e,height:t,depth:1};n=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:vi,depthBuffer:!0,stencilBuffer:!1,resolveDepthBuffer:!0,resolveStencilBuffer:!0,depthTexture:null,samples:0,count:1},n);const r=new yn(s,n.mapping,n.wrapS,n.wrapT,n.magFilter,n.minFilter,n.format,n.type,n.anisotropy,n.colorSpace);r.flipY=!1,r.generateMipmaps=n.generateMipmaps,r.internalFormat=n.internalFormat,this.textures=[];const o=n.count;for(let a=0;a<o;a++)this.textures[a]=r.clone(),this.textures[a].isRenderTargetTexture=!0;this.depthBuffer=n.depthBuffer,this.stencilBuffer=n.stencilBuffer,this.resolveDepthBuffer=n.resolveDepthBuffer,this.resolveStencilBuffer=n.resolveStencilBuffer,this.depthTexture=n.depthTexture,this.samples=n.samples}get texture(){return this.textures[0]}set texture(e){this.textures[0]=e}setSize(e,t,n=1){if(this.width!==e||this.height!==t||this.depth!==n){this.width=e,this.height=t,this.depth=n;for(let s=0,r=this.textures.length;s<r;s++)this.textures[s].image.width=e,this.textures[s].image.height=t,this.textures[s].image.depth=n;this.dispose()}this.viewport.set(0,0,e,t),this.scissor.set(0,0,e,t)}clone(){return new this.constructor().copy(this)}copy(e){this.width=e.width,this.height=e.height,this.depth=e.depth,this.scissor.copy(e.scissor),this.scissorTest=e.scissorTest,this.viewport.copy(e.viewport),this.textures.length=0;for(let n=0,s=e.textures.length;n<s;n++)this.textures[n]=e.textures[n].clone(),this.textures[n].isRenderTargetTexture=!0;const t=Object.assign({},e.texture.image);return this.texture.source=new pp(t),this.depthBuffer=e.depthBuffer,this.stencilBuffer=e.stencilBuffer,this.resolveDepthBuffer=e.resolveDepthBuffer,this.resolveStencilBuffer=e.resolveStencilBuffer,e.depthTexture!==null&&(this.depthTexture=e.depthTexture.clone()),this.samples=e.samples,this}dispose(){this.dispatchEvent({type:"dispose"})}}class Fs extends uE{constructor(e=1,t=1,n={}){super(e,t,n),this.isWebGLRenderTarget=!0}}class mp extends yn{constructor(e=null,t=1,n=1,s=1){super(null),this.isDataArrayTexture=!0,this.image={data:e,width:t,height:n,depth:s},this.magFilter=oi,this.minFilter=oi,this.wrapR=As,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}addLayerUpdate(e){this.layerUpdates.add(e)}clearLayerUpdates(){this.layerUpdates.clear()}}class hE extends yn{constructor(e=null,t=1,n=1,s=1){super(null),this.isData3DTexture=!0,this.image={data:e,width:t,height:n,depth:s},this.magFilter=oi,this.minFilter=oi,this.wrapR=As,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}}class Mo{constructor(e=0,t=0,n=0,s=1){this.isQuaternion=!0,this._x=e,this._y=t,this._z=n,this._w=s}static slerpFlat(e,t,n,s,r,o,a){let l=n[s+0],c=n[s+1],u=n[s+2],h=n[s+3];const d=r[o+0],m=r[o+1],_=r[o+2],v=r[o+3];if(a===0){e[t+0]=l,e[t+1]=c,e[t+2]=u,e[t+3]=h;return}if(a===1){e[t+0]=d,e[t+1]=m,e[t+2]=_,e[t+3]=v;return}if(h!==v||l!==d||c!==m||u!==_){let p=1-a;const f=l*d+c*m+u*_+h*v,E=f>=0?1:-1,T=1-f*f;if(T>Number.EPSILON){const k=Math.sqrt(T),L=Math.atan2(k,f*E);p=Math.sin(p*L)/k,a=Math.sin(a*L)/k}const M=a*E;if(l=l*p+d*M,c=c*p+m*M,u=u*p+_*M,h=h*p+v*M,p===1-a){const k=1/Math.sqrt(l*l+c*c+u*u+h*h);l*=k,c*=k,u*=k,h*=k}}e[t]=l,e[t+1]=c,e[t+2]=u,e[t+3]=h}static multiplyQuaternionsFlat(e,t,n,s,r,o){const a=n[s],l=n[s+1],c=n[s+2],u=n[s+3],h=r[o],d=r[o+1],m=r[o+2],_=r[o+3];return e[t]=a*_+u*h+l*m-c*d,e[t+1]=l*_+u*d+c*h-a*m,e[t+2]=c*_+u*m+a*d-l*h,e[t+3]=u*_-a*h-l*d-c*m,e}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get w(){return this._w}set w(e){this._w=e,this._onChangeCallback()}set(e,t,n,s){return this._x=e,this._y=t,this._z=n,this._w=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(e){return this._x=e.x,this._y=e.y,this._z=e.z,this._w=e.w,this._onChangeCallback(),this}setFromEuler(e,t=!0){const n=e._x,s=e._y,r=e._z,o=e._order,a=Math.cos,l=Math.sin,c=a(n/2),u=a(s/2),h=a(r/2),d=l(n/2),m=l(s/2),_=l(r/2);switch(o){case"XYZ":this._x=d*u*h+c*m*_,this._y=c*m*h-d*u*_,this._z=c*u*_+d*m*h,this._w=c*u*h-d*m*_;break;case"YXZ":this._x=d*u*h+c*m*_,this._y=c*m*h-d*u*_,this._z=c*u*_-d*m*h,this._w=c*u*h+d*m*_;break;case"ZXY":this._x=d*u*h-c*m*_,this._y=c*m*h+d*u*_,this._z=c*u*_+d*m*h,this._w=c*u*h-d*m*_;break;case"ZYX":this._x=d*u*h-c*m*_,this._y=c*m*h+d*u*_,this._z=c*u*_-d*m*h,this._w=c*u*h+d*m*_;break;case"YZX":this._x=d*u*h+c*m*_,this._y=c*m*h+d*u*_,this._z=c*u*_-d*m*h,this._w=c*u*h-d*m*_;break;case"XZY":this._x=d*u*h-c*m*_,this._y=c*m*h-d*u*_,this._z=c*u*_+d*m*h,this._w=c*u*h+d*m*_;break;default:console.warn("THREE.Quaternion: .setFromEuler() encountered an unknown order: "+o)}return t===!0&&this._onChangeCallback(),this}setFromAxisAngle(e,t){const n=t/2,s=Math.sin(n);return this._x=e.x*s,this._y=e.y*s,this._z=e.z*s,this._w=Math.cos(n),this._onChangeCallback(),this}setFromRotationMatrix(e){const t=e.elements,n=t[0],s=t[4],r=t[8],o=t[1],a=t[5],l=t[9],c=t[2],u=t[6],h=t[10],d=n+a+h;if(d>0){const m=.5/Math.sqrt(d+1);this._w=.25/m,this._x=(u-l)*m,this._y=(r-c)*m,this._z=(o-s)*m}else if(n>a&&n>h){const m=2*Math.sqrt(1+n-a-h);this._w=(u-l)/m,this._x=.25*m,this._y=(s+o)/m,this._z=(r+c)/m}else if(a>h){const m=2*Math.sqrt(1+a-n-h);this._w=(r-c)/m,this._x=(s+o)/m,this._y=.25*m,this._z=(l+u)/m}else{const m=2*Math.sqrt(1+h-n-a);this._w=(o-s)/m,this._x=(r+c)/m,this._y=(l+u)/m,this._z=.25*m}return this._onChangeCallback(),this}setFromUnitVectors(e,t){let n=e.dot(t)+1;return n<Number.EPSILON?(n=0,Math.abs(e.x)>Math.abs(e.z)?(this._x=-e.y,this._y=e.x,this._z=0,this._w=n):(this._x=0,this._y=-e.z,this._z=e.y,this._w=n)):(this._x=e.y*t.z-e.z*t.y,this._y=e.z*t.x-e.x*t.z,this._z=e.x*t.y-e.y*t.x,this._w=n),this.normalize()}angleTo(e){return 2*Math.acos(Math.abs(Tn(this.dot(e),-1,1)))}rotateTowards(e,t){const n=this.angleTo(e);if(n===0)return this;const s=Math.min(1,t/n);return this.slerp(e,s),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(e){return this._x*e._x+this._y*e._y+this._z*e._z+this._w*e._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let e=this.length();return e===0?(this._x=0,this._y=0,this._z=0,this._w=1):(e=1/e,this._x=this._x*e,this._y=this._y*e,this._z=this._z*e,this._w=this._w*e),this._onChangeCallback(),this}multiply(e){return this.multiplyQuaternions(this,e)}premultiply(e){return this.multiplyQuaternions(e,this)}multiplyQuaternions(e,t){const n=e._x,s=e._y,r=e._z,o=e._w,a=t._x,l=t._y,c=t._z,u=t._w;return this._x=n*u+o*a+s*c-r*l,this._y=s*u+o*l+r*a-n*c,this._z=r*u+o*c+n*l-s*a,this._w=o*u-n*a-s*l-r*c,this._onChangeCallback(),this}slerp(e,t){if(t===0)return this;if(t===1)return this.copy(e);const n=this._x,s=this._y,r=this._z,o=this._w;let a=o*e._w+n*e._x+s*e._y+r*e._z;if(a<0?(this._w=-e._w,this._x=-e._x,this._y=-e._y,this._z=-e._z,a=-a):this.copy(e),a>=1)return this._w=o,this._x=n,this._y=s,this._z=r,this;const l=1-a*a;if(l<=Number.EPSILON){const m=1-t;return this._w=m*o+t*this._w,this._x=m*n+t*this._x,this._y=m*s+t*this._y,this._z=m*r+t*this._z,this.normalize(),this}const c=Math.sqrt(l),u=Math.atan2(c,a),h=Math.sin((1-t)*u)/c,d=Math.sin(t*u)/c;return this._w=o*h+this._w*d,this._x=n*h+this._x*d,this._y=s*h+this._y*d,this._z=r*h+this._z*d,this._onChangeCallback(),this}slerpQuaternions(e,t,n){return this.copy(e).slerp(t,n)}random(){const e=2*Math.PI*Math.random(),t=2*Math.PI*Math.random(),n=Math.random(),s=Math.sqrt(1-n),r=Math.sqrt(n);return this.set(s*Math.sin(e),s*Math.cos(e),r*Math.sin(t),r*Math.cos(t))}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._w===this._w}fromArray(e,t=0){return this._x=e[t],this._y=e[t+1],this._z=e[t+2],this._w=e[t+3],this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._w,e}fromBufferAttribute(e,t){return this._x=e.getX(t),this._y=e.getY(t),this._z=e.getZ(t),this._w=e.getW(t),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}}class Y{constructor(e=0,t=0,n=0){Y.prototype.isVector3=!0,this.x=e,this.y=t,this.z=n}set(e,t,n){return n===void 0&&(n=this.z),this.x=e,this.y=t,this.z=n,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;default:throw new Error("index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this}multiplyVectors(e,t){return this.x=e.x*t.x,this.y=e.y*t.y,this.z=e.z*t.z,this}applyEuler(e){return this.applyQuaternion(ed.setFromEuler(e))}applyAxisAngle(e,t){return this.applyQuaternion(ed.setFromAxisAngle(e,t))}applyMatrix3(e){const t=this.x,n=this.y,s=this.z,r=e.elements;return this.x=r[0]*t+r[3]*n+r[6]*s,this.y=r[1]*t+r[4]*n+r[7]*s,this.z=r[2]*t+r[5]*n+r[8]*s,this}applyNormalMatrix(e){return this.applyMatrix3(e).normalize()}applyMatrix4(e){const t=this.x,n=this.y,s=this.z,r=e.elements,o=1/(r[3]*t+r[7]*n+r[11]*s+r[15]);return this.x=(r[0]*t+r[4]*n+r[8]*s+r[12])*o,this.y=(r[1]*t+r[5]*n+r[9]*s+r[13])*o,this.z=(r[2]*t+r[6]*n+r[10]*s+r[14])*o,this}applyQuaternion(e){const t=this.x,n=this.y,s=this.z,r=e.x,o=e.y,a=e.z,l=e.w,c=2*(o*s-a*n),u=2*(a*t-r*s),h=2*(r*n-o*t);return this.x=t+l*c+o*h-a*u,this.y=n+l*u+a*c-r*h,this.z=s+l*h+r*u-o*c,this}project(e){return this.applyMatrix4(e.matrixWorldInverse).applyMatrix4(e.projectionMatrix)}unproject(e){return this.applyMatrix4(e.projectionMatrixInverse).applyMatrix4(e.matrixWorld)}transformDirection(e){const t=this.x,n=this.y,s=this.z,r=e.elements;return this.x=r[0]*t+r[4]*n+r[8]*s,this.y=r[1]*t+r[5]*n+r[9]*s,this.z=r[2]*t+r[6]*n+r[10]*s,this.normalize()}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this}divideScalar(e){return this.multiplyScalar(1/e)}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this}clamp(e,t){return this.x=Math.max(e.x,Math.min(t.x,this.x)),this.y=Math.max(e.y,Math.min(t.y,this.y)),this.z=Math.max(e.z,Math.min(t.z,this.z)),this}clampScalar(e,t){return this.x=Math.max(e,Math.min(t,this.x)),this.y=Math.max(e,Math.min(t,this.y)),this.z=Math.max(e,Math.min(t,this.z)),this}clampLength(e,t){const n=this.length();return this.divideScalar(n||1).multiplyScalar(Math.max(e,Math.min(t,n)))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this}lerpVectors(e,t,n){return this.x=e.x+(t.x-e.x)*n,this.y=e.y+(t.y-e.y)*n,this.z=e.z+(t.z-e.z)*n,this}cross(e){return this.crossVectors(this,e)}crossVectors(e,t){const n=e.x,s=e.y,r=e.z,o=t.x,a=t.y,l=t.z;return this.x=s*l-r*a,this.y=r*o-n*l,this.z=n*a-s*o,this}projectOnVector(e){const t=e.lengthSq();if(t===0)return this.set(0,0,0);const n=e.dot(this)/t;return this.copy(e).multiplyScalar(n)}projectOnPlane(e){return fl.copy(this).projectOnVector(e),this.sub(fl)}reflect(e){return this.sub(fl.copy(e).multiplyScalar(2*this.dot(e)))}angleTo(e){const t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;const n=this.dot(e)/t;return Math.acos(Tn(n,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){const t=this.x-e.x,n=this.y-e.y,s=this.z-e.z;return t*t+n*n+s*s}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)+Math.abs(this.z-e.z)}setFromSpherical(e){return this.setFromSphericalCoords(e.radius,e.phi,e.theta)}setFromSphericalCoords(e,t,n){const s=Math.sin(t)*e;return this.x=s*Math.sin(n),this.y=Math.cos(t)*e,this.z=s*Math.cos(n),this}setFromCylindrical(e){return this.setFromCylindricalCoords(e.radius,e.theta,e.y)}setFromCylindricalCoords(e,t,n){return this.x=e*Math.sin(t),this.y=n,this.z=e*Math.cos(t),this}setFromMatrixPosition(e){const t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this}setFromMatrixScale(e){const t=this.setFromMatrixColumn(e,0).length(),n=this.setFromMatrixColumn(e,1).length(),s=this.setFromMatrixColumn(e,2).length();return this.x=t,this.y=n,this.z=s,this}setFromMatrixColumn(e,t){return this.fromArray(e.elements,t*4)}setFromMatrix3Column(e,t){return this.fromArray(e.elements,t*3)}setFromEuler(e){return this.x=e._x,this.y=e._y,this.z=e._z,this}setFromColor(e){return this.x=e.r,this.y=e.g,this.z=e.b,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){const e=Math.random()*Math.PI*2,t=Math.random()*2-1,n=Math.sqrt(1-t*t);return this.x=n*Math.cos(e),this.y=t,this.z=n*Math.sin(e),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}}const fl=new Y,ed=new Mo;class So{constructor(e=new Y(1/0,1/0,1/0),t=new Y(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=e,this.max=t}set(e,t){return this.min.copy(e),this.max.copy(t),this}setFromArray(e){this.makeEmpty();for(let t=0,n=e.length;t<n;t+=3)this.expandByPoint(Zn.fromArray(e,t));return this}setFromBufferAttribute(e){this.makeEmpty();for(let t=0,n=e.count;t<n;t++)this.expandByPoint(Zn.fromBufferAttribute(e,t));return this}setFromPoints(e){this.makeEmpty();for(let t=0,n=e.length;t<n;t++)this.expandByPoint(e[t]);return this}setFromCenterAndSize(e,t){const n=Zn.copy(t).multiplyScalar(.5);return this.min.copy(e).sub(n),this.max.copy(e).add(n),this}setFromObject(e,t=!1){return this.makeEmpty(),this.expandByObject(e,t)}clone(){return new this.constructor().copy(this)}copy(e){return this.min.copy(e.min),this.max.copy(e.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(e){return this.isEmpty()?e.set(0,0,0):e.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(e){return this.isEmpty()?e.set(0,0,0):e.subVectors(this.max,this.min)}expandByPoint(e){return this.min.min(e),this.max.max(e),this}expandByVector(e){return this.min.sub(e),this.max.add(e),this}expandByScalar(e){return this.min.addScalar(-e),this.max.addScalar(e),this}expandByObject(e,t=!1){e.updateWorldMatrix(!1,!1);const n=e.geometry;if(n!==void 0){const r=n.getAttribute("position");if(t===!0&&r!==void 0&&e.isInstancedMesh!==!0)for(let o=0,a=r.count;o<a;o++)e.isMesh===!0?e.getVertexPosition(o,Zn):Zn.fromBufferAttribute(r,o),Zn.applyMatrix4(e.matrixWorld),this.expandByPoint(Zn);else e.boundingBox!==void 0?(e.boundingBox===null&&e.computeBoundingBox(),Oo.copy(e.boundingBox)):(n.boundingBox===null&&n.computeBoundingBox(),Oo.copy(n.boundingBox)),Oo.applyMatrix4(e.matrixWorld),this.union(Oo)}const s=e.children;for(let r=0,o=s.length;r<o;r++)this.expandByObject(s[r],t);return this}containsPoint(e){return e.x>=this.min.x&&e.x<=this.max.x&&e.y>=this.min.y&&e.y<=this.max.y&&e.z>=this.min.z&&e.z<=this.max.z}containsBox(e){return this.min.x<=e.min.x&&e.max.x<=this.max.x&&this.min.y<=e.min.y&&e.max.y<=this.max.y&&this.min.z<=e.min.z&&e.max.z<=this.max.z}getParameter(e,t){return t.set((e.x-this.min.x)/(this.max.x-this.min.x),(e.y-this.min.y)/(this.max.y-this.min.y),(e.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(e){return e.max.x>=this.min.x&&e.min.x<=this.max.x&&e.max.y>=this.min.y&&e.min.y<=this.max.y&&e.max.z>=this.min.z&&e.min.z<=this.max.z}intersectsSphere(e){return this.clampPoint(e.center,Zn),Zn.distanceToSquared(e.center)<=e.radius*e.radius}intersectsPlane(e){let t,n;return e.normal.x>0?(t=e.normal.x*this.min.x,n=e.normal.x*this.max.x):(t=e.normal.x*this.max.x,n=e.normal.x*this.min.x),e.normal.y>0?(t+=e.normal.y*this.min.y,n+=e.normal.y*this.max.y):(t+=e.normal.y*this.max.y,n+=e.normal.y*this.min.y),e.normal.z>0?(t+=e.normal.z*this.min.z,n+=e.normal.z*this.max.z):(t+=e.normal.z*this.max.z,n+=e.normal.z*this.min.z),t<=-e.constant&&n>=-e.constant}intersectsTriangle(e){if(this.isEmpty())return!1;this.getCenter(jr),ko.subVectors(this.max,jr),er.subVectors(e.a,jr),tr.subVectors(e.b,jr),nr.subVectors(e.c,jr),$i.subVectors(tr,er),Xi.subVectors(nr,tr),fs.subVectors(er,nr);let t=[0,-$i.z,$i.y,0,-Xi.z,Xi.y,0,-fs.z,fs.y,$i.z,0,-$i.x,Xi.z,0,-Xi.x,fs.z,0,-fs.x,-$i.y,$i.x,0,-Xi.y,Xi.x,0,-fs.y,fs.x,0];return!pl(t,er,tr,nr,ko)||(t=[1,0,0,0,1,0,0,0,1],!pl(t,er,tr,nr,ko))?!1:(Bo.crossVectors($i,Xi),t=[Bo.x,Bo.y,Bo.z],pl(t,er,tr,nr,ko))}clampPoint(e,t){return t.copy(e).clamp(this.min,this.max)}distanceToPoint(e){return this.clampPoint(e,Zn).distanceTo(e)}getBoundingSphere(e){return this.isEmpty()?e.makeEmpty():(this.getCenter(e.center),e.radius=this.getSize(Zn).length()*.5),e}intersect(e){return this.min.max(e.min),this.max.min(e.max),this.isEmpty()&&this.makeEmpty(),this}union(e){return this.min.min(e.min),this.max.max(e.max),this}applyMatrix4(e){return this.isEmpty()?this:(Ai[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(e),Ai[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(e),Ai[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(e),Ai[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(e),Ai[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(e),Ai[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(e),Ai[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(e),Ai[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(e),this.setFromPoints(Ai),this)}translate(e){return this.min.add(e),this.max.add(e),this}equals(e){return e.min.equals(this.min)&&e.max.equals(this.max)}}const Ai=[new Y,new Y,new Y,new Y,new Y,new Y,new Y,new Y],Zn=new Y,Oo=new So,er=new Y,tr=new Y,nr=new Y,$i=new Y,Xi=new Y,fs=new Y,jr=new Y,ko=new Y,Bo=new Y,ps=new Y;function pl(i,e,t,n,s){for(let r=0,o=i.length-3;r<=o;r+=3){ps.fromArray(i,r);const a=s.x*Math.abs(ps.x)+s.y*Math.abs(ps.y)+s.z*Math.abs(ps.z),l=e.dot(ps),c=t.dot(ps),u=n.dot(ps);if(Math.max(-Math.max(l,c,u),Math.min(l,c,u))>a)return!1}return!0}const dE=new So,Kr=new Y,ml=new Y;class za{constructor(e=new Y,t=-1){this.isSphere=!0,this.center=e,this.radius=t}set(e,t){return this.center.copy(e),this.radius=t,this}setFromPoints(e,t){const n=this.center;t!==void 0?n.copy(t):dE.setFromPoints(e).getCenter(n);let s=0;for(let r=0,o=e.length;r<o;r++)s=Math.max(s,n.distanceToSquared(e[r]));return this.radius=Math.sqrt(s),this}copy(e){return this.center.copy(e.center),this.radius=e.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(e){return e.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(e){return e.distanceTo(this.center)-this.radius}intersectsSphere(e){const t=this.radius+e.radius;return e.center.distanceToSquared(this.center)<=t*t}intersectsBox(e){return e.intersectsSphere(this)}intersectsPlane(e){return Math.abs(e.distanceToPoint(this.center))<=this.radius}clampPoint(e,t){const n=this.center.distanceToSquared(e);return t.copy(e),n>this.radius*this.radius&&(t.sub(this.center).normalize(),t.multiplyScalar(this.radius).add(this.center)),t}getBoundingBox(e){return this.isEmpty()?(e.makeEmpty(),e):(e.set(this.center,this.center),e.expandByScalar(this.radius),e)}applyMatrix4(e){return this.center.applyMatrix4(e),this.radius=this.radius*e.getMaxScaleOnAxis(),this}translate(e){return this.center.add(e),this}expandByPoint(e){if(this.isEmpty())return this.center.copy(e),this.radius=0,this;Kr.subVectors(e,this.center);const t=Kr.lengthSq();if(t>this.radius*this.radius){const n=Math.sqrt(t),s=(n-this.radius)*.5;this.center.addScaledVector(Kr,s/n),this.radius+=s}return this}union(e){return e.isEmpty()?this:this.isEmpty()?(this.copy(e),this):(this.center.equals(e.center)===!0?this.radius=Math.max(this.radius,e.radius):(ml.subVectors(e.center,this.center).setLength(e.radius),this.expandByPoint(Kr.copy(e.center).add(ml)),this.expandByPoint(Kr.copy(e.center).sub(ml))),this)}equals(e){return e.center.equals(this.center)&&e.radius===this.radius}clone(){return new this.constructor().copy(this)}}const Ri=new Y,gl=new Y,zo=new Y,qi=new Y,_l=new Y,Ho=new Y,vl=new Y;class _u{constructor(e=new Y,t=new Y(0,0,-1)){this.origin=e,this.direction=t}set(e,t){return this.origin.copy(e),this.direction.copy(t),this}copy(e){return this.origin.copy(e.origin),this.direction.copy(e.direction),this}at(e,t){return t.copy(this.origin).addScaledVector(this.direction,e)}lookAt(e){return this.direction.copy(e).sub(this.origin).normalize(),this}recast(e){return this.origin.copy(this.at(e,Ri)),this}closestPointToPoint(e,t){t.subVectors(e,this.origin);const n=t.dot(this.direction);return n<0?t.copy(this.origin):t.copy(this.origin).addScaledVector(this.direction,n)}distanceToPoint(e){return Math.sqrt(this.distanceSqToPoint(e))}distanceSqToPoint(e){const t=Ri.subVectors(e,this.origin).dot(this.direction);return t<0?this.origin.distanceToSquared(e):(Ri.copy(this.origin).addScaledVector(this.direction,t),Ri.distanceToSquared(e))}distanceSqToSegment(e,t,n,s){gl.copy(e).add(t).multiplyScalar(.5),zo.copy(t).sub(e).normalize(),qi.copy(this.origin).sub(gl);const r=e.distanceTo(t)*.5,o=-this.direction.dot(zo),a=qi.dot(this.direction),l=-qi.dot(zo),c=qi.lengthSq(),u=Math.abs(1-o*o);let h,d,m,_;if(u>0)if(h=o*l-a,d=o*a-l,_=r*u,h>=0)if(d>=-_)if(d<=_){const v=1/u;h*=v,d*=v,m=h*(h+o*d+2*a)+d*(o*h+d+2*l)+c}else d=r,h=Math.max(0,-(o*d+a)),m=-h*h+d*(d+2*l)+c;else d=-r,h=Math.max(0,-(o*d+a)),m=-h*h+d*(d+2*l)+c;else d<=-_?(h=Math.max(0,-(-o*r+a)),d=h>0?-r:Math.min(Math.max(-r,-l),r),m=-h*h+d*(d+2*l)+c):d<=_?(h=0,d=Math.min(Math.max(-r,-l),r),m=d*(d+2*l)+c):(h=Math.max(0,-(o*r+a)),d=h>0?r:Math.min(Math.max(-r,-l),r),m=-h*h+d*(d+2*l)+c);else d=o>0?-r:r,h=Math.max(0,-(o*d+a)),m=-h*h+d*(d+2*l)+c;return n&&n.copy(this.origin).addScaledVector(this.direction,h),s&&s.copy(gl).addScaledVector(zo,d),m}intersectSphere(e,t){Ri.subVectors(e.center,this.origin);const n=Ri.dot(this.direction),s=Ri.dot(Ri)-n*n,r=e.radius*e.radius;if(s>r)return null;const o=Math.sqrt(r-s),a=n-o,l=n+o;return l<0?null:a<0?this.at(l,t):this.at(a,t)}intersectsSphere(e){return this.distanceSqToPoint(e.center)<=e.radius*e.radius}distanceToPlane(e){const t=e.normal.dot(this.direction);if(t===0)return e.distanceToPoint(this.origin)===0?0:null;const n=-(this.origin.dot(e.normal)+e.constant)/t;return n>=0?n:null}intersectPlane(e,t){const n=this.distanceToPlane(e);return n===null?null:this.at(n,t)}intersectsPlane(e){const t=e.distanceToPoint(this.origin);return t===0||e.normal.dot(this.direction)*t<0}intersectBox(e,t){let n,s,r,o,a,l;const c=1/this.direction.x,u=1/this.direction.y,h=1/this.direction.z,d=this.origin;return c>=0?(n=(e.min.x-d.x)*c,s=(e.max.x-d.x)*c):(n=(e.max.x-d.x)*c,s=(e.min.x-d.x)*c),u>=0?(r=(e.min.y-d.y)*u,o=(e.max.y-d.y)*u):(r=(e.max.y-d.y)*u,o=(e.min.y-d.y)*u),n>o||r>s||((r>n||isNaN(n))&&(n=r),(o<s||isNaN(s))&&(s=o),h>=0?(a=(e.min.z-d.z)*h,l=(e.max.z-d.z)*h):(a=(e.max.z-d.z)*h,l=(e.min.z-d.z)*h),n>l||a>s)||((a>n||n!==n)&&(n=a),(l<s||s!==s)&&(s=l),s<0)?null:this.at(n>=0?n:s,t)}intersectsBox(e){return this.intersectBox(e,Ri)!==null}intersectTriangle(e,t,n,s,r){_l.subVectors(t,e),Ho.subVectors(n,e),vl.crossVectors(_l,Ho);let o=this.direction.dot(vl),a;if(o>0){if(s)return null;a=1}else if(o<0)a=-1,o=-o;else return null;qi.subVectors(this.origin,e);const l=a*this.direction.dot(Ho.crossVectors(qi,Ho));if(l<0)return null;const c=a*this.direction.dot(_l.cross(qi));if(c<0||l+c>o)return null;const u=-a*qi.dot(vl);return u<0?null:this.at(u/o,r)}applyMatrix4(e){return this.origin.applyMatrix4(e),this.direction.transformDirection(e),this}equals(e){return e.origin.equals(this.origin)&&e.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}}class Bt{constructor(e,t,n,s,r,o,a,l,c,u,h,d,m,_,v,p){Bt.prototype.isMatrix4=!0,this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],e!==void 0&&this.set(e,t,n,s,r,o,a,l,c,u,h,d,m,_,v,p)}set(e,t,n,s,r,o,a,l,c,u,h,d,m,_,v,p){const f=this.elements;return f[0]=e,f[4]=t,f[8]=n,f[12]=s,f[1]=r,f[5]=o,f[9]=a,f[13]=l,f[2]=c,f[6]=u,f[10]=h,f[14]=d,f[3]=m,f[7]=_,f[11]=v,f[15]=p,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new Bt().fromArray(this.elements)}copy(e){const t=this.elements,n=e.elements;return t[0]=n[0],t[1]=n[1],t[2]=n[2],t[3]=n[3],t[4]=n[4],t[5]=n[5],t[6]=n[6],t[7]=n[7],t[8]=n[8],t[9]=n[9],t[10]=n[10],t[11]=n[11],t[12]=n[12],t[13]=n[13],t[14]=n[14],t[15]=n[15],this}copyPosition(e){const t=this.elements,n=e.elements;return t[12]=n[12],t[13]=n[13],t[14]=n[14],this}setFromMatrix3(e){const t=e.elements;return this.set(t[0],t[3],t[6],0,t[1],t[4],t[7],0,t[2],t[5],t[8],0,0,0,0,1),this}extractBasis(e,t,n){return e.setFromMatrixColumn(this,0),t.setFromMatrixColumn(this,1),n.setFromMatrixColumn(this,2),this}makeBasis(e,t,n){return this.set(e.x,t.x,n.x,0,e.y,t.y,n.y,0,e.z,t.z,n.z,0,0,0,0,1),this}extractRotation(e){const t=this.elements,n=e.elements,s=1/ir.setFromMatrixColumn(e,0).length(),r=1/ir.setFromMatrixColumn(e,1).length(),o=1/ir.setFromMatrixColumn(e,2).length();return t[0]=n[0]*s,t[1]=n[1]*s,t[2]=n[2]*s,t[3]=0,t[4]=n[4]*r,t[5]=n[5]*r,t[6]=n[6]*r,t[7]=0,t[8]=n[8]*o,t[9]=n[9]*o,t[10]=n[10]*o,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromEuler(e){const t=this.elements,n=e.x,s=e.y,r=e.z,o=Math.cos(n),a=Math.sin(n),l=Math.cos(s),c=Math.sin(s),u=Math.cos(r),h=Math.sin(r);if(e.order==="XYZ"){const d=o*u,m=o*h,_=a*u,v=a*h;t[0]=l*u,t[4]=-l*h,t[8]=c,t[1]=m+_*c,t[5]=d-v*c,t[9]=-a*l,t[2]=v-d*c,t[6]=_+m*c,t[10]=o*l}else if(e.order==="YXZ"){const d=l*u,m=l*h,_=c*u,v=c*h;t[0]=d+v*a,t[4]=_*a-m,t[8]=o*c,t[1]=o*h,t[5]=o*u,t[9]=-a,t[2]=m*a-_,t[6]=v+d*a,t[10]=o*l}else if(e.order==="ZXY"){const d=l*u,m=l*h,_=c*u,v=c*h;t[0]=d-v*a,t[4]=-o*h,t[8]=_+m*a,t[1]=m+_*a,t[5]=o*u,t[9]=v-d*a,t[2]=-o*c,t[6]=a,t[10]=o*l}else if(e.order==="ZYX"){const d=o*u,m=o*h,_=a*u,v=a*h;t[0]=l*u,t[4]=_*c-m,t[8]=d*c+v,t[1]=l*h,t[5]=v*c+d,t[9]=m*c-_,t[2]=-c,t[6]=a*l,t[10]=o*l}else if(e.order==="YZX"){const d=o*l,m=o*c,_=a*l,v=a*c;t[0]=l*u,t[4]=v-d*h,t[8]=_*h+m,t[1]=h,t[5]=o*u,t[9]=-a*u,t[2]=-c*u,t[6]=m*h+_,t[10]=d-v*h}else if(e.order==="XZY"){const d=o*l,m=o*c,_=a*l,v=a*c;t[0]=l*u,t[4]=-h,t[8]=c*u,t[1]=d*h+v,t[5]=o*u,t[9]=m*h-_,t[2]=_*h-m,t[6]=a*u,t[10]=v*h+d}return t[3]=0,t[7]=0,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromQuaternion(e){return this.compose(fE,e,pE)}lookAt(e,t,n){const s=this.elements;return Dn.subVectors(e,t),Dn.lengthSq()===0&&(Dn.z=1),Dn.normalize(),Yi.crossVectors(n,Dn),Yi.lengthSq()===0&&(Math.abs(n.z)===1?Dn.x+=1e-4:Dn.z+=1e-4,Dn.normalize(),Yi.crossVectors(n,Dn)),Yi.normalize(),Vo.crossVectors(Dn,Yi),s[0]=Yi.x,s[4]=Vo.x,s[8]=Dn.x,s[1]=Yi.y,s[5]=Vo.y,s[9]=Dn.y,s[2]=Yi.z,s[6]=Vo.z,s[10]=Dn.z,this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){const n=e.elements,s=t.elements,r=this.elements,o=n[0],a=n[4],l=n[8],c=n[12],u=n[1],h=n[5],d=n[9],m=n[13],_=n[2],v=n[6],p=n[10],f=n[14],E=n[3],T=n[7],M=n[11],k=n[15],L=s[0],D=s[4],N=s[8],w=s[12],y=s[1],R=s[5],V=s[9],U=s[13],K=s[2],X=s[6],Q=s[10],J=s[14],ne=s[3],fe=s[7],he=s[11],_e=s[15];return r[0]=o*L+a*y+l*K+c*ne,r[4]=o*D+a*R+l*X+c*fe,r[8]=o*N+a*V+l*Q+c*he,r[12]=o*w+a*U+l*J+c*_e,r[1]=u*L+h*y+d*K+m*ne,r[5]=u*D+h*R+d*X+m*fe,r[9]=u*N+h*V+d*Q+m*he,r[13]=u*w+h*U+d*J+m*_e,r[2]=_*L+v*y+p*K+f*ne,r[6]=_*D+v*R+p*X+f*fe,r[10]=_*N+v*V+p*Q+f*he,r[14]=_*w+v*U+p*J+f*_e,r[3]=E*L+T*y+M*K+k*ne,r[7]=E*D+T*R+M*X+k*fe,r[11]=E*N+T*V+M*Q+k*he,r[15]=E*w+T*U+M*J+k*_e,this}multiplyScalar(e){const t=this.elements;return t[0]*=e,t[4]*=e,t[8]*=e,t[12]*=e,t[1]*=e,t[5]*=e,t[9]*=e,t[13]*=e,t[2]*=e,t[6]*=e,t[10]*=e,t[14]*=e,t[3]*=e,t[7]*=e,t[11]*=e,t[15]*=e,this}determinant(){const e=this.elements,t=e[0],n=e[4],s=e[8],r=e[12],o=e[1],a=e[5],l=e[9],c=e[13],u=e[2],h=e[6],d=e[10],m=e[14],_=e[3],v=e[7],p=e[11],f=e[15];return _*(+r*l*h-s*c*h-r*a*d+n*c*d+s*a*m-n*l*m)+v*(+t*l*m-t*c*d+r*o*d-s*o*m+s*c*u-r*l*u)+p*(+t*c*h-t*a*m-r*o*h+n*o*m+r*a*u-n*c*u)+f*(-s*a*u-t*l*h+t*a*d+s*o*h-n*o*d+n*l*u)}transpose(){const e=this.elements;let t;return t=e[1],e[1]=e[4],e[4]=t,t=e[2],e[2]=e[8],e[8]=t,t=e[6],e[6]=e[9],e[9]=t,t=e[3],e[3]=e[12],e[12]=t,t=e[7],e[7]=e[13],e[13]=t,t=e[11],e[11]=e[14],e[14]=t,this}setPosition(e,t,n){const s=this.elements;return e.isVector3?(s[12]=e.x,s[13]=e.y,s[14]=e.z):(s[12]=e,s[13]=t,s[14]=n),this}invert(){const e=this.elements,t=e[0],n=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],u=e[8],h=e[9],d=e[10],m=e[11],_=e[12],v=e[13],p=e[14],f=e[15],E=h*p*c-v*d*c+v*l*m-a*p*m-h*l*f+a*d*f,T=_*d*c-u*p*c-_*l*m+o*p*m+u*l*f-o*d*f,M=u*v*c-_*h*c+_*a*m-o*v*m-u*a*f+o*h*f,k=_*h*l-u*v*l-_*a*d+o*v*d+u*a*p-o*h*p,L=t*E+n*T+s*M+r*k;if(L===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);const D=1/L;return e[0]=E*D,e[1]=(v*d*r-h*p*r-v*s*m+n*p*m+h*s*f-n*d*f)*D,e[2]=(a*p*r-v*l*r+v*s*c-n*p*c-a*s*f+n*l*f)*D,e[3]=(h*l*r-a*d*r-h*s*c+n*d*c+a*s*m-n*l*m)*D,e[4]=T*D,e[5]=(u*p*r-_*d*r+_*s*m-t*p*m-u*s*f+t*d*f)*D,e[6]=(_*l*r-o*p*r-_*s*c+t*p*c+o*s*f-t*l*f)*D,e[7]=(o*d*r-u*l*r+u*s*c-t*d*c-o*s*m+t*l*m)*D,e[8]=M*D,e[9]=(_*h*r-u*v*r-_*n*m+t*v*m+u*n*f-t*h*f)*D,e[10]=(o*v*r-_*a*r+_*n*c-t*v*c-o*n*f+t*a*f)*D,e[11]=(u*a*r-o*h*r-u*n*c+t*h*c+o*n*m-t*a*m)*D,e[12]=k*D,e[13]=(u*v*s-_*h*s+_*n*d-t*v*d-u*n*p+t*h*p)*D,e[14]=(_*a*s-o*v*s-_*n*l+t*v*l+o*n*p-t*a*p)*D,e[15]=(o*h*s-u*a*s+u*n*l-t*h*l-o*n*d+t*a*d)*D,this}scale(e){const t=this.elements,n=e.x,s=e.y,r=e.z;return t[0]*=n,t[4]*=s,t[8]*=r,t[1]*=n,t[5]*=s,t[9]*=r,t[2]*=n,t[6]*=s,t[10]*=r,t[3]*=n,t[7]*=s,t[11]*=r,this}getMaxScaleOnAxis(){const e=this.elements,t=e[0]*e[0]+e[1]*e[1]+e[2]*e[2],n=e[4]*e[4]+e[5]*e[5]+e[6]*e[6],s=e[8]*e[8]+e[9]*e[9]+e[10]*e[10];return Math.sqrt(Math.max(t,n,s))}makeTranslation(e,t,n){return e.isVector3?this.set(1,0,0,e.x,0,1,0,e.y,0,0,1,e.z,0,0,0,1):this.set(1,0,0,e,0,1,0,t,0,0,1,n,0,0,0,1),this}makeRotationX(e){const t=Math.cos(e),n=Math.sin(e);return this.set(1,0,0,0,0,t,-n,0,0,n,t,0,0,0,0,1),this}makeRotationY(e){const t=Math.cos(e),n=Math.sin(e);return this.set(t,0,n,0,0,1,0,0,-n,0,t,0,0,0,0,1),this}makeRotationZ(e){const t=Math.cos(e),n=Math.sin(e);return this.set(t,-n,0,0,n,t,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(e,t){const n=Math.cos(t),s=Math.sin(t),r=1-n,o=e.x,a=e.y,l=e.z,c=r*o,u=r*a;return this.set(c*o+n,c*a-s*l,c*l+s*a,0,c*a+s*l,u*a+n,u*l-s*o,0,c*l-s*a,u*l+s*o,r*l*l+n,0,0,0,0,1),this}makeScale(e,t,n){return this.set(e,0,0,0,0,t,0,0,0,0,n,0,0,0,0,1),this}makeShear(e,t,n,s,r,o){return this.set(1,n,r,0,e,1,o,0,t,s,1,0,0,0,0,1),this}compose(e,t,n){const s=this.elements,r=t._x,o=t._y,a=t._z,l=t._w,c=r+r,u=o+o,h=a+a,d=r*c,m=r*u,_=r*h,v=o*u,p=o*h,f=a*h,E=l*c,T=l*u,M=l*h,k=n.x,L=n.y,D=n.z;return s[0]=(1-(v+f))*k,s[1]=(m+M)*k,s[2]=(_-T)*k,s[3]=0,s[4]=(m-M)*L,s[5]=(1-(d+f))*L,s[6]=(p+E)*L,s[7]=0,s[8]=(_+T)*D,s[9]=(p-E)*D,s[10]=(1-(d+v))*D,s[11]=0,s[12]=e.x,s[13]=e.y,s[14]=e.z,s[15]=1,this}decompose(e,t,n){const s=this.elements;let r=ir.set(s[0],s[1],s[2]).length();const o=ir.set(s[4],s[5],s[6]).length(),a=ir.set(s[8],s[9],s[10]).length();this.determinant()<0&&(r=-r),e.x=s[12],e.y=s[13],e.z=s[14],Jn.copy(this);const c=1/r,u=1/o,h=1/a;return Jn.elements[0]*=c,Jn.elements[1]*=c,Jn.elements[2]*=c,Jn.elements[4]*=u,Jn.elements[5]*=u,Jn.elements[6]*=u,Jn.elements[8]*=h,Jn.elements[9]*=h,Jn.elements[10]*=h,t.setFromRotationMatrix(Jn),n.x=r,n.y=o,n.z=a,this}makePerspective(e,t,n,s,r,o,a=Ui){const l=this.elements,c=2*r/(t-e),u=2*r/(n-s),h=(t+e)/(t-e),d=(n+s)/(n-s);let m,_;if(a===Ui)m=-(o+r)/(o-r),_=-2*o*r/(o-r);else if(a===ya)m=-o/(o-r),_=-o*r/(o-r);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+a);return l[0]=c,l[4]=0,l[8]=h,l[12]=0,l[1]=0,l[5]=u,l[9]=d,l[13]=0,l[2]=0,l[6]=0,l[10]=m,l[14]=_,l[3]=0,l[7]=0,l[11]=-1,l[15]=0,this}makeOrthographic(e,t,n,s,r,o,a=Ui){const l=this.elements,c=1/(t-e),u=1/(n-s),h=1/(o-r),d=(t+e)*c,m=(n+s)*u;let _,v;if(a===Ui)_=(o+r)*h,v=-2*h;else if(a===ya)_=r*h,v=-1*h;else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+a);return l[0]=2*c,l[4]=0,l[8]=0,l[12]=-d,l[1]=0,l[5]=2*u,l[9]=0,l[13]=-m,l[2]=0,l[6]=0,l[10]=v,l[14]=-_,l[3]=0,l[7]=0,l[11]=0,l[15]=1,this}equals(e){const t=this.elements,n=e.elements;for(let s=0;s<16;s++)if(t[s]!==n[s])return!1;return!0}fromArray(e,t=0){for(let n=0;n<16;n++)this.elements[n]=e[n+t];return this}toArray(e=[],t=0){const n=this.elements;return e[t]=n[0],e[t+1]=n[1],e[t+2]=n[2],e[t+3]=n[3],e[t+4]=n[4],e[t+5]=n[5],e[t+6]=n[6],e[t+7]=n[7],e[t+8]=n[8],e[t+9]=n[9],e[t+10]=n[10],e[t+11]=n[11],e[t+12]=n[12],e[t+13]=n[13],e[t+14]=n[14],e[t+15]=n[15],e}}const ir=new Y,Jn=new Bt,fE=new Y(0,0,0),pE=new Y(1,1,1),Yi=new Y,Vo=new Y,Dn=new Y,td=new Bt,nd=new Mo;class Si{constructor(e=0,t=0,n=0,s=Si.DEFAULT_ORDER){this.isEuler=!0,this._x=e,this._y=t,this._z=n,this._order=s}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get order(){return this._order}set order(e){this._order=e,this._onChangeCallback()}set(e,t,n,s=this._order){return this._x=e,this._y=t,this._z=n,this._order=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(e){return this._x=e._x,this._y=e._y,this._z=e._z,this._order=e._order,this._onChangeCallback(),this}setFromRotationMatrix(e,t=this._order,n=!0){const s=e.elements,r=s[0],o=s[4],a=s[8],l=s[1],c=s[5],u=s[9],h=s[2],d=s[6],m=s[10];switch(t){case"XYZ":this._y=Math.asin(Tn(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(-u,m),this._z=Math.atan2(-o,r)):(this._x=Math.atan2(d,c),this._z=0);break;case"YXZ":this._x=Math.asin(-Tn(u,-1,1)),Math.abs(u)<.9999999?(this._y=Math.atan2(a,m),this._z=Math.atan2(l,c)):(this._y=Math.atan2(-h,r),this._z=0);break;case"ZXY":this._x=Math.asin(Tn(d,-1,1)),Math.abs(d)<.9999999?(this._y=Math.atan2(-h,m),this._z=Math.atan2(-o,c)):(this._y=0,this._z=Math.atan2(l,r));break;case"ZYX":this._y=Math.asin(-Tn(h,-1,1)),Math.abs(h)<.9999999?(this._x=Math.atan2(d,m),this._z=Math.atan2(l,r)):(this._x=0,this._z=Math.atan2(-o,c));break;case"YZX":this._z=Math.asin(Tn(l,-1,1)),Math.abs(l)<.9999999?(this._x=Math.atan2(-u,c),this._y=Math.atan2(-h,r)):(this._x=0,this._y=Math.atan2(a,m));break;case"XZY":this._z=Math.asin(-Tn(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(d,c),this._y=Math.atan2(a,r)):(this._x=Math.atan2(-u,m),this._y=0);break;default:console.warn("THREE.Euler: .setFromRotationMatrix() encountered an unknown order: "+t)}return this._order=t,n===!0&&this._onChangeCallback(),this}setFromQuaternion(e,t,n){return td.makeRotationFromQuaternion(e),this.setFromRotationMatrix(td,t,n)}setFromVector3(e,t=this._order){return this.set(e.x,e.y,e.z,t)}reorder(e){return nd.setFromEuler(this),this.setFromQuaternion(nd,e)}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._order===this._order}fromArray(e){return this._x=e[0],this._y=e[1],this._z=e[2],e[3]!==void 0&&(this._order=e[3]),this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._order,e}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}}Si.DEFAULT_ORDER="XYZ";class vu{constructor(){this.mask=1}set(e){this.mask=(1<<e|0)>>>0}enable(e){this.mask|=1<<e|0}enableAll(){this.mask=-1}toggle(e){this.mask^=1<<e|0}disable(e){this.mask&=~(1<<e|0)}disableAll(){this.mask=0}test(e){return(this.mask&e.mask)!==0}isEnabled(e){return(this.mask&(1<<e|0))!==0}}let mE=0;const id=new Y,sr=new Mo,Ci=new Bt,Go=new Y,Zr=new Y,gE=new Y,_E=new Mo,sd=new Y(1,0,0),rd=new Y(0,1,0),od=new Y(0,0,1),ad={type:"added"},vE={type:"removed"},rr={type:"childadded",child:null},xl={type:"childremoved",child:null};class Jt extends Fr{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:mE++}),this.uuid=xo(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=Jt.DEFAULT_UP.clone();const e=new Y,t=new Si,n=new Mo,s=new Y(1,1,1);function r(){n.setFromEuler(t,!1)}function o(){t.setFromQuaternion(n,void 0,!1)}t._onChange(r),n._onChange(o),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:e},rotation:{configurable:!0,enumerable:!0,value:t},quaternion:{configurable:!0,enumerable:!0,value:n},scale:{configurable:!0,enumerable:!0,value:s},modelViewMatrix:{value:new Bt},normalMatrix:{value:new et}}),this.matrix=new Bt,this.matrixWorld=new Bt,this.matrixAutoUpdate=Jt.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=Jt.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new vu,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.userData={}}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(e){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(e),this.matrix.decompose(this.position,this.quaternion,this.scale)}applyQuaternion(e){return this.quaternion.premultiply(e),this}setRotationFromAxisAngle(e,t){this.quaternion.setFromAxisAngle(e,t)}setRotationFromEuler(e){this.quaternion.setFromEuler(e,!0)}setRotationFromMatrix(e){this.quaternion.setFromRotationMatrix(e)}setRotationFromQuaternion(e){this.quaternion.copy(e)}rotateOnAxis(e,t){return sr.setFromAxisAngle(e,t),this.quaternion.multiply(sr),this}rotateOnWorldAxis(e,t){return sr.setFromAxisAngle(e,t),this.quaternion.premultiply(sr),this}rotateX(e){return this.rotateOnAxis(sd,e)}rotateY(e){return this.rotateOnAxis(rd,e)}rotateZ(e){return this.rotateOnAxis(od,e)}translateOnAxis(e,t){return id.copy(e).applyQuaternion(this.quaternion),this.position.add(id.multiplyScalar(t)),this}translateX(e){return this.translateOnAxis(sd,e)}translateY(e){return this.translateOnAxis(rd,e)}translateZ(e){return this.translateOnAxis(od,e)}localToWorld(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(this.matrixWorld)}worldToLocal(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(Ci.copy(this.matrixWorld).invert())}lookAt(e,t,n){e.isVector3?Go.copy(e):Go.set(e,t,n);const s=this.parent;this.updateWorldMatrix(!0,!1),Zr.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?Ci.lookAt(Zr,Go,this.up):Ci.lookAt(Go,Zr,this.up),this.quaternion.setFromRotationMatrix(Ci),s&&(Ci.extractRotation(s.matrixWorld),sr.setFromRotationMatrix(Ci),this.quaternion.premultiply(sr.invert()))}add(e){if(arguments.length>1){for(let t=0;t<arguments.length;t++)this.add(arguments[t]);return this}return e===this?(console.error("THREE.Object3D.add: object can't be added as a child of itself.",e),this):(e&&e.isObject3D?(e.removeFromParent(),e.parent=this,this.children.push(e),e.dispatchEvent(ad),rr.child=e,this.dispatchEvent(rr),rr.child=null):console.error("THREE.Object3D.add: object not an instance of THREE.Object3D.",e),this)}remove(e){if(arguments.length>1){for(let n=0;n<arguments.length;n++)this.remove(arguments[n]);return this}const t=this.children.indexOf(e);return t!==-1&&(e.parent=null,this.children.splice(t,1),e.dispatchEvent(vE),xl.child=e,this.dispatchEvent(xl),xl.child=null),this}removeFromParent(){const e=this.parent;return e!==null&&e.remove(this),this}clear(){return this.remove(...this.children)}attach(e){return this.updateWorldMatrix(!0,!1),Ci.copy(this.matrixWorld).invert(),e.parent!==null&&(e.parent.updateWorldMatrix(!0,!1),Ci.multiply(e.parent.matrixWorld)),e.applyMatrix4(Ci),e.removeFromParent(),e.parent=this,this.children.push(e),e.updateWorldMatrix(!1,!0),e.dispatchEvent(ad),rr.child=e,this.dispatchEvent(rr),rr.child=null,this}getObjectById(e){return this.getObjectByProperty("id",e)}getObjectByName(e){return this.getObjectByProperty("name",e)}getObjectByProperty(e,t){if(this[e]===t)return this;for(let n=0,s=this.children.length;n<s;n++){const o=this.children[n].getObjectByProperty(e,t);if(o!==void 0)return o}}getObjectsByProperty(e,t,n=[]){this[e]===t&&n.push(this);const s=this.children;for(let r=0,o=s.length;r<o;r++)s[r].getObjectsByProperty(e,t,n);return n}getWorldPosition(e){return this.updateWorldMatrix(!0,!1),e.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(Zr,e,gE),e}getWorldScale(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(Zr,_E,e),e}getWorldDirection(e){this.updateWorldMatrix(!0,!1);const t=this.matrixWorld.elements;return e.set(t[8],t[9],t[10]).normalize()}raycast(){}traverse(e){e(this);const t=this.children;for(let n=0,s=t.length;n<s;n++)t[n].traverse(e)}traverseVisible(e){if(this.visible===!1)return;e(this);const t=this.children;for(let n=0,s=t.length;n<s;n++)t[n].traverseVisible(e)}traverseAncestors(e){const t=this.parent;t!==null&&(e(t),t.traverseAncestors(e))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale),this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(e){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||e)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,e=!0);const t=this.children;for(let n=0,s=t.length;n<s;n++)t[n].updateMatrixWorld(e)}updateWorldMatrix(e,t){const n=this.parent;if(e===!0&&n!==null&&n.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),t===!0){const s=this.children;for(let r=0,o=s.length;r<o;r++)s[r].updateWorldMatrix(!1,!0)}}toJSON(e){const t=e===void 0||typeof e=="string",n={};t&&(e={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},n.metadata={version:4.6,type:"Object",generator:"Object3D.toJSON"});const s={};s.uuid=this.uuid,s.type=this.type,this.name!==""&&(s.name=this.name),this.castShadow===!0&&(s.castShadow=!0),this.receiveShadow===!0&&(s.receiveShadow=!0),this.visible===!1&&(s.visible=!1),this.frustumCulled===!1&&(s.frustumCulled=!1),this.renderOrder!==0&&(s.renderOrder=this.renderOrder),Object.keys(this.userData).length>0&&(s.userData=this.userData),s.layers=this.layers.mask,s.matrix=this.matrix.toArray(),s.up=this.up.toArray(),this.matrixAutoUpdate===!1&&(s.matrixAutoUpdate=!1),this.isInstancedMesh&&(s.type="InstancedMesh",s.count=this.count,s.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(s.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(s.type="BatchedMesh",s.perObjectFrustumCulled=this.perObjectFrustumCulled,s.sortObjects=this.sortObjects,s.drawRanges=this._drawRanges,s.reservedRanges=this._reservedRanges,s.visibility=this._visibility,s.active=this._active,s.bounds=this._bounds.map(a=>({boxInitialized:a.boxInitialized,boxMin:a.box.min.toArray(),boxMax:a.box.max.toArray(),sphereInitialized:a.sphereInitialized,sphereRadius:a.sphere.radius,sphereCenter:a.sphere.center.toArray()})),s.maxInstanceCount=this._maxInstanceCount,s.maxVertexCount=this._maxVertexCount,s.maxIndexCount=this._maxIndexCount,s.geometryInitialized=this._geometryInitialized,s.geometryCount=this._geometryCount,s.matricesTexture=this._matricesTexture.toJSON(e),this._colorsTexture!==null&&(s.colorsTexture=this._colorsTexture.toJSON(e)),this.boundingSphere!==null&&(s.boundingSphere={center:s.boundingSphere.center.toArray(),radius:s.boundingSphere.radius}),this.boundingBox!==null&&(s.boundingBox={min:s.boundingBox.min.toArray(),max:s.boundingBox.max.toArray()}));function r(a,l){return a[l.uuid]===void 0&&(a[l.uuid]=l.toJSON(e)),l.uuid}if(this.isScene)this.background&&(this.background.isColor?s.background=this.background.toJSON():this.background.isTexture&&(s.background=this.background.toJSON(e).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(s.environment=this.environment.toJSON(e).uuid);else if(this.isMesh||this.isLine||this.isPoints){s.geometry=r(e.geometries,this.geometry);const a=this.geometry.parameters;if(a!==void 0&&a.shapes!==void 0){const l=a.shapes;if(Array.isArray(l))for(let c=0,u=l.length;c<u;c++){const h=l[c];r(e.shapes,h)}else r(e.shapes,l)}}if(this.isSkinnedMesh&&(s.bindMode=this.bindMode,s.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(r(e.skeletons,this.skeleton),s.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){const a=[];for(let l=0,c=this.material.length;l<c;l++)a.push(r(e.materials,this.material[l]));s.material=a}else s.material=r(e.materials,this.material);if(this.children.length>0){s.children=[];for(let a=0;a<this.children.length;a++)s.children.push(this.children[a].toJSON(e).object)}if(this.animations.length>0){s.animations=[];for(let a=0;a<this.animations.length;a++){const l=this.animations[a];s.animations.push(r(e.animations,l))}}if(t){const a=o(e.geometries),l=o(e.materials),c=o(e.textures),u=o(e.images),h=o(e.shapes),d=o(e.skeletons),m=o(e.animations),_=o(e.nodes);a.length>0&&(n.geometries=a),l.length>0&&(n.materials=l),c.length>0&&(n.textures=c),u.length>0&&(n.images=u),h.length>0&&(n.shapes=h),d.length>0&&(n.skeletons=d),m.length>0&&(n.animations=m),_.length>0&&(n.nodes=_)}return n.object=s,n;function o(a){const l=[];for(const c in a){const u=a[c];delete u.metadata,l.push(u)}return l}}clone(e){return new this.constructor().copy(this,e)}copy(e,t=!0){if(this.name=e.name,this.up.copy(e.up),this.position.copy(e.position),this.rotation.order=e.rotation.order,this.quaternion.copy(e.quaternion),this.scale.copy(e.scale),this.matrix.copy(e.matrix),this.matrixWorld.copy(e.matrixWorld),this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrixWorldAutoUpdate=e.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=e.matrixWorldNeedsUpdate,this.layers.mask=e.layers.mask,this.visible=e.visible,this.castShadow=e.castShadow,this.receiveShadow=e.receiveShadow,this.frustumCulled=e.frustumCulled,this.renderOrder=e.renderOrder,this.animations=e.animations.slice(),this.userData=JSON.parse(JSON.stringify(e.userData)),t===!0)for(let n=0;n<e.children.length;n++){const s=e.children[n];this.add(s.clone())}return this}}Jt.DEFAULT_UP=new Y(0,1,0);Jt.DEFAULT_MATRIX_AUTO_UPDATE=!0;Jt.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;const Qn=new Y,Pi=new Y,Ml=new Y,Li=new Y,or=new Y,ar=new Y,ld=new Y,Sl=new Y,yl=new Y,bl=new Y,El=new Gt,wl=new Gt,Tl=new Gt;class ii{constructor(e=new Y,t=new Y,n=new Y){this.a=e,this.b=t,this.c=n}static getNormal(e,t,n,s){s.subVectors(n,t),Qn.subVectors(e,t),s.cross(Qn);const r=s.lengthSq();return r>0?s.multiplyScalar(1/Math.sqrt(r)):s.set(0,0,0)}static getBarycoord(e,t,n,s,r){Qn.subVectors(s,t),Pi.subVectors(n,t),Ml.subVectors(e,t);const o=Qn.dot(Qn),a=Qn.dot(Pi),l=Qn.dot(Ml),c=Pi.dot(Pi),u=Pi.dot(Ml),h=o*c-a*a;if(h===0)return r.set(0,0,0),null;const d=1/h,m=(c*l-a*u)*d,_=(o*u-a*l)*d;return r.set(1-m-_,_,m)}static containsPoint(e,t,n,s){return this.getBarycoord(e,t,n,s,Li)===null?!1:Li.x>=0&&Li.y>=0&&Li.x+Li.y<=1}static getInterpolation(e,t,n,s,r,o,a,l){return this.getBarycoord(e,t,n,s,Li)===null?(l.x=0,l.y=0,"z"in l&&(l.z=0),"w"in l&&(l.w=0),null):(l.setScalar(0),l.addScaledVector(r,Li.x),l.addScaledVector(o,Li.y),l.addScaledVector(a,Li.z),l)}static getInterpolatedAttribute(e,t,n,s,r,o){return El.setScalar(0),wl.setScalar(0),Tl.setScalar(0),El.fromBufferAttribute(e,t),wl.fromBufferAttribute(e,n),Tl.fromBufferAttribute(e,s),o.setScalar(0),o.addScaledVector(El,r.x),o.addScaledVector(wl,r.y),o.addScaledVector(Tl,r.z),o}static isFrontFacing(e,t,n,s){return Qn.subVectors(n,t),Pi.subVectors(e,t),Qn.cross(Pi).dot(s)<0}set(e,t,n){return this.a.copy(e),this.b.copy(t),this.c.copy(n),this}setFromPointsAndIndices(e,t,n,s){return this.a.copy(e[t]),this.b.copy(e[n]),this.c.copy(e[s]),this}setFromAttributeAndIndices(e,t,n,s){return this.a.fromBufferAttribute(e,t),this.b.fromBufferAttribute(e,n),this.c.fromBufferAttribute(e,s),this}clone(){return new this.constructor().copy(this)}copy(e){return this.a.copy(e.a),this.b.copy(e.b),this.c.copy(e.c),this}getArea(){return Qn.subVectors(this.c,this.b),Pi.subVectors(this.a,this.b),Qn.cross(Pi).length()*.5}getMidpoint(e){return e.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(e){return ii.getNormal(this.a,this.b,this.c,e)}getPlane(e){return e.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(e,t){return ii.getBarycoord(e,this.a,this.b,this.c,t)}getInterpolation(e,t,n,s,r){return ii.getInterpolation(e,this.a,this.b,this.c,t,n,s,r)}containsPoint(e){return ii.containsPoint(e,this.a,this.b,this.c)}isFrontFacing(e){return ii.isFrontFacing(this.a,this.b,this.c,e)}intersectsBox(e){return e.intersectsTriangle(this)}closestPointToPoint(e,t){const n=this.a,s=this.b,r=this.c;let o,a;or.subVectors(s,n),ar.subVectors(r,n),Sl.subVectors(e,n);const l=or.dot(Sl),c=ar.dot(Sl);if(l<=0&&c<=0)return t.copy(n);yl.subVectors(e,s);const u=or.dot(yl),h=ar.dot(yl);if(u>=0&&h<=u)return t.copy(s);const d=l*h-u*c;if(d<=0&&l>=0&&u<=0)return o=l/(l-u),t.copy(n).addScaledVector(or,o);bl.subVectors(e,r);const m=or.dot(bl),_=ar.dot(bl);if(_>=0&&m<=_)return t.copy(r);const v=m*c-l*_;if(v<=0&&c>=0&&_<=0)return a=c/(c-_),t.copy(n).addScaledVector(ar,a);const p=u*_-m*h;if(p<=0&&h-u>=0&&m-_>=0)return ld.subVectors(r,s),a=(h-u)/(h-u+(m-_)),t.copy(s).addScaledVector(ld,a);const f=1/(p+v+d);return o=v*f,a=d*f,t.copy(n).addScaledVector(or,o).addScaledVector(ar,a)}equals(e){return e.a.equals(this.a)&&e.b.equals(this.b)&&e.c.equals(this.c)}}const gp={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},ji={h:0,s:0,l:0},Wo={h:0,s:0,l:0};function Al(i,e,t){return t<0&&(t+=1),t>1&&(t-=1),t<1/6?i+(e-i)*6*t:t<1/2?e:t<2/3?i+(e-i)*6*(2/3-t):i}class at{constructor(e,t,n){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(e,t,n)}set(e,t,n){if(t===void 0&&n===void 0){const s=e;s&&s.isColor?this.copy(s):typeof s=="number"?this.setHex(s):typeof s=="string"&&this.setStyle(s)}else this.setRGB(e,t,n);return this}setScalar(e){return this.r=e,this.g=e,this.b=e,this}setHex(e,t=Un){return e=Math.floor(e),this.r=(e>>16&255)/255,this.g=(e>>8&255)/255,this.b=(e&255)/255,pt.toWorkingColorSpace(this,t),this}setRGB(e,t,n,s=pt.workingColorSpace){return this.r=e,this.g=t,this.b=n,pt.toWorkingColorSpace(this,s),this}setHSL(e,t,n,s=pt.workingColorSpace){if(e=nE(e,1),t=Tn(t,0,1),n=Tn(n,0,1),t===0)this.r=this.g=this.b=n;else{const r=n<=.5?n*(1+t):n+t-n*t,o=2*n-r;this.r=Al(o,r,e+1/3),this.g=Al(o,r,e),this.b=Al(o,r,e-1/3)}return pt.toWorkingColorSpace(this,s),this}setStyle(e,t=Un){function n(r){r!==void 0&&parseFloat(r)<1&&console.warn("THREE.Color: Alpha component of "+e+" will be ignored.")}let s;if(s=/^(\w+)\(([^\)]*)\)/.exec(e)){let r;const o=s[1],a=s[2];switch(o){case"rgb":case"rgba":if(r=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d*\.?\d+)\s*)?$/.exec(a))return n(r[4]),this.setRGB(Math.min(255,parseInt(r[1],10))/255,Math.min(255,parseInt(r[2],10))/255,Math.min(255,parseInt(r[3],10))/255,t);if(r=/^\s*(\d+)\%\s*,\s*(\d+)\%\s*,\s*(\d+)\%\s*(?:,\s*(\d*\.?\d+)\s*)?$/.exec(a))return n(r[4]),this.setRGB(Math.min(100,parseInt(r[1],10))/100,Math.min(100,parseInt(r[2],10))/100,Math.min(100,parseInt(r[3],10))/100,t);break;case"hsl":case"hsla":if(r=/^\s*(\d*\.?\d+)\s*,\s*(\d*\.?\d+)\%\s*,\s*(\d*\.?\d+)\%\s*(?:,\s*(\d*\.?\d+)\s*)?$/.exec(a))return n(r[4]),this.setHSL(parseFloat(r[1])/360,parseFloat(r[2])/100,parseFloat(r[3])/100,t);break;default:console.warn("THREE.Color: Unknown color model "+e)}}else if(s=/^\#([A-Fa-f\d]+)$/.exec(e)){const r=s[1],o=r.length;if(o===3)return this.setRGB(parseInt(r.charAt(0),16)/15,parseInt(r.charAt(1),16)/15,parseInt(r.charAt(2),16)/15,t);if(o===6)return this.setHex(parseInt(r,16),t);console.warn("THREE.Color: Invalid hex color "+e)}else if(e&&e.length>0)return this.setColorName(e,t);return this}setColorName(e,t=Un){const n=gp[e.toLowerCase()];return n!==void 0?this.setHex(n,t):console.warn("THREE.Color: Unknown color "+e),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(e){return this.r=e.r,this.g=e.g,this.b=e.b,this}copySRGBToLinear(e){return this.r=ki(e.r),this.g=ki(e.g),this.b=ki(e.b),this}copyLinearToSRGB(e){return this.r=vr(e.r),this.g=vr(e.g),this.b=vr(e.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(e=Un){return pt.fromWorkingColorSpace(fn.copy(this),e),Math.round(Tn(fn.r*255,0,255))*65536+Math.round(Tn(fn.g*255,0,255))*256+Math.round(Tn(fn.b*255,0,255))}getHexString(e=Un){return("000000"+this.getHex(e).toString(16)).slice(-6)}getHSL(e,t=pt.workingColorSpace){pt.fromWorkingColorSpace(fn.copy(this),t);const n=fn.r,s=fn.g,r=fn.b,o=Math.max(n,s,r),a=Math.min(n,s,r);let l,c;const u=(a+o)/2;if(a===o)l=0,c=0;else{const h=o-a;switch(c=u<=.5?h/(o+a):h/(2-o-a),o){case n:l=(s-r)/h+(s<r?6:0);break;case s:l=(r-n)/h+2;break;case r:l=(n-s)/h+4;break}l/=6}return e.h=l,e.s=c,e.l=u,e}getRGB(e,t=pt.workingColorSpace){return pt.fromWorkingColorSpace(fn.copy(this),t),e.r=fn.r,e.g=fn.g,e.b=fn.b,e}getStyle(e=Un){pt.fromWorkingColorSpace(fn.copy(this),e);const t=fn.r,n=fn.g,s=fn.b;return e!==Un?`color(${e} ${t.toFixed(3)} ${n.toFixed(3)} ${s.toFixed(3)})`:`rgb(${Math.round(t*255)},${Math.round(n*255)},${Math.round(s*255)})`}offsetHSL(e,t,n){return this.getHSL(ji),this.setHSL(ji.h+e,ji.s+t,ji.l+n)}add(e){return this.r+=e.r,this.g+=e.g,this.b+=e.b,this}addColors(e,t){return this.r=e.r+t.r,this.g=e.g+t.g,this.b=e.b+t.b,this}addScalar(e){return this.r+=e,this.g+=e,this.b+=e,this}sub(e){return this.r=Math.max(0,this.r-e.r),this.g=Math.max(0,this.g-e.g),this.b=Math.max(0,this.b-e.b),this}multiply(e){return this.r*=e.r,this.g*=e.g,this.b*=e.b,this}multiplyScalar(e){return this.r*=e,this.g*=e,this.b*=e,this}lerp(e,t){return this.r+=(e.r-this.r)*t,this.g+=(e.g-this.g)*t,this.b+=(e.b-this.b)*t,this}lerpColors(e,t,n){return this.r=e.r+(t.r-e.r)*n,this.g=e.g+(t.g-e.g)*n,this.b=e.b+(t.b-e.b)*n,this}lerpHSL(e,t){this.getHSL(ji),e.getHSL(Wo);const n=ul(ji.h,Wo.h,t),s=ul(ji.s,Wo.s,t),r=ul(ji.l,Wo.l,t);return this.setHSL(n,s,r),this}setFromVector3(e){return this.r=e.x,this.g=e.y,this.b=e.z,this}applyMatrix3(e){const t=this.r,n=this.g,s=this.b,r=e.elements;return this.r=r[0]*t+r[3]*n+r[6]*s,this.g=r[1]*t+r[4]*n+r[7]*s,this.b=r[2]*t+r[5]*n+r[8]*s,this}equals(e){return e.r===this.r&&e.g===this.g&&e.b===this.b}fromArray(e,t=0){return this.r=e[t],this.g=e[t+1],this.b=e[t+2],this}toArray(e=[],t=0){return e[t]=this.r,e[t+1]=this.g,e[t+2]=this.b,e}fromBufferAttribute(e,t){return this.r=e.getX(t),this.g=e.getY(t),this.b=e.getZ(t),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}}const fn=new at;at.NAMES=gp;let xE=0;class Or extends Fr{static get type(){return"Material"}get type(){return this.constructor.type}set type(e){}constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:xE++}),this.uuid=xo(),this.name="",this.blending=gr,this.side=rs,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=nc,this.blendDst=ic,this.blendEquation=ws,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new at(0,0,0),this.blendAlpha=0,this.depthFunc=wr,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=$h,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=Js,this.stencilZFail=Js,this.stencilZPass=Js,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(e){this._alphaTest>0!=e>0&&this.version++,this._alphaTest=e}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(e){if(e!==void 0)for(const t in e){const n=e[t];if(n===void 0){console.warn(`THREE.Material: parameter '${t}' has value of undefined.`);continue}const s=this[t];if(s===void 0){console.warn(`THREE.Material: '${t}' is not a property of THREE.${this.type}.`);continue}s&&s.isColor?s.set(n):s&&s.isVector3&&n&&n.isVector3?s.copy(n):this[t]=n}}toJSON(e){const t=e===void 0||typeof e=="string";t&&(e={textures:{},images:{}});const n={metadata:{version:4.6,type:"Material",generator:"Material.toJSON"}};n.uuid=this.uuid,n.type=this.type,this.name!==""&&(n.name=this.name),this.color&&this.color.isColor&&(n.color=this.color.getHex()),this.roughness!==void 0&&(n.roughness=this.roughness),this.metalness!==void 0&&(n.metalness=this.metalness),this.sheen!==void 0&&(n.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(n.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(n.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(n.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&this.emissiveIntensity!==1&&(n.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(n.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(n.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(n.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(n.shininess=this.shininess),this.clearcoat!==void 0&&(n.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(n.clearcoatRoughness=this.clearcoatRoughness),this.clearcoatMap&&this.clearcoatMap.isTexture&&(n.clearcoatMap=this.clearcoatMap.toJSON(e).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(n.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(e).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(n.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(e).uuid,n.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.dispersion!==void 0&&(n.dispersion=this.dispersion),this.iridescence!==void 0&&(n.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(n.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessRange!==void 0&&(n.iridescenceThicknessRange=this.iridescenceThicknessRange),this.iridescenceMap&&this.iridescenceMap.isTexture&&(n.iridescenceMap=this.iridescenceMap.toJSON(e).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(n.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(e).uuid),this.anisotropy!==void 0&&(n.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(n.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(n.anisotropyMap=this.anisotropyMap.toJSON(e).uuid),this.map&&this.map.isTexture&&(n.map=this.map.toJSON(e).uuid),this.matcap&&this.matcap.isTexture&&(n.matcap=this.matcap.toJSON(e).uuid),this.alphaMap&&this.alphaMap.isTexture&&(n.alphaMap=this.alphaMap.toJSON(e).uuid),this.lightMap&&this.lightMap.isTexture&&(n.lightMap=this.lightMap.toJSON(e).uuid,n.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(n.aoMap=this.aoMap.toJSON(e).uuid,n.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(n.bumpMap=this.bumpMap.toJSON(e).uuid,n.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(n.normalMap=this.normalMap.toJSON(e).uuid,n.normalMapType=this.normalMapType,n.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(n.displacementMap=this.displacementMap.toJSON(e).uuid,n.displacementScale=this.displacementScale,n.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(n.roughnessMap=this.roughnessMap.toJSON(e).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(n.metalnessMap=this.metalnessMap.toJSON(e).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(n.emissiveMap=this.emissiveMap.toJSON(e).uuid),this.specularMap&&this.specularMap.isTexture&&(n.specularMap=this.specularMap.toJSON(e).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(n.specularIntensityMap=this.specularIntensityMap.toJSON(e).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(n.specularColorMap=this.specularColorMap.toJSON(e).uuid),this.envMap&&this.envMap.isTexture&&(n.envMap=this.envMap.toJSON(e).uuid,this.combine!==void 0&&(n.combine=this.combine)),this.envMapRotation!==void 0&&(n.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(n.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(n.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(n.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(n.gradientMap=this.gradientMap.toJSON(e).uuid),this.transmission!==void 0&&(n.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(n.transmissionMap=this.transmissionMap.toJSON(e).uuid),this.thickness!==void 0&&(n.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(n.thicknessMap=this.thicknessMap.toJSON(e).uuid),this.attenuationDistance!==void 0&&this.attenuationDistance!==1/0&&(n.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(n.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(n.size=this.size),this.shadowSide!==null&&(n.shadowSide=this.shadowSide),this.sizeAttenuation!==void 0&&(n.sizeAttenuation=this.sizeAttenuation),this.blending!==gr&&(n.blending=this.blending),this.side!==rs&&(n.side=this.side),this.vertexColors===!0&&(n.vertexColors=!0),this.opacity<1&&(n.opacity=this.opacity),this.transparent===!0&&(n.transparent=!0),this.blendSrc!==nc&&(n.blendSrc=this.blendSrc),this.blendDst!==ic&&(n.blendDst=this.blendDst),this.blendEquation!==ws&&(n.blendEquation=this.blendEquation),this.blendSrcAlpha!==null&&(n.blendSrcAlpha=this.blendSrcAlpha),this.blendDstAlpha!==null&&(n.blendDstAlpha=this.blendDstAlpha),this.blendEquationAlpha!==null&&(n.blendEquationAlpha=this.blendEquationAlpha),this.blendColor&&this.blendColor.isColor&&(n.blendColor=this.blendColor.getHex()),this.blendAlpha!==0&&(n.blendAlpha=this.blendAlpha),this.depthFunc!==wr&&(n.depthFunc=this.depthFunc),this.depthTest===!1&&(n.depthTest=this.depthTest),this.depthWrite===!1&&(n.depthWrite=this.depthWrite),this.colorWrite===!1&&(n.colorWrite=this.colorWrite),this.stencilWriteMask!==255&&(n.stencilWriteMask=this.stencilWriteMask),this.stencilFunc!==$h&&(n.stencilFunc=this.stencilFunc),this.stencilRef!==0&&(n.stencilRef=this.stencilRef),this.stencilFuncMask!==255&&(n.stencilFuncMask=this.stencilFuncMask),this.stencilFail!==Js&&(n.stencilFail=this.stencilFail),this.stencilZFail!==Js&&(n.stencilZFail=this.stencilZFail),this.stencilZPass!==Js&&(n.stencilZPass=this.stencilZPass),this.stencilWrite===!0&&(n.stencilWrite=this.stencilWrite),this.rotation!==void 0&&this.rotation!==0&&(n.rotation=this.rotation),this.polygonOffset===!0&&(n.polygonOffset=!0),this.polygonOffsetFactor!==0&&(n.polygonOffsetFactor=this.polygonOffsetFactor),this.polygonOffsetUnits!==0&&(n.polygonOffsetUnits=this.polygonOffsetUnits),this.linewidth!==void 0&&this.linewidth!==1&&(n.linewidth=this.linewidth),this.dashSize!==void 0&&(n.dashSize=this.dashSize),this.gapSize!==void 0&&(n.gapSize=this.gapSize),this.scale!==void 0&&(n.scale=this.scale),this.dithering===!0&&(n.dithering=!0),this.alphaTest>0&&(n.alphaTest=this.alphaTest),this.alphaHash===!0&&(n.alphaHash=!0),this.alphaToCoverage===!0&&(n.alphaToCoverage=!0),this.premultipliedAlpha===!0&&(n.premultipliedAlpha=!0),this.forceSinglePass===!0&&(n.forceSinglePass=!0),this.wireframe===!0&&(n.wireframe=!0),this.wireframeLinewidth>1&&(n.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!=="round"&&(n.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!=="round"&&(n.wireframeLinejoin=this.wireframeLinejoin),this.flatShading===!0&&(n.flatShading=!0),this.visible===!1&&(n.visible=!1),this.toneMapped===!1&&(n.toneMapped=!1),this.fog===!1&&(n.fog=!1),Object.keys(this.userData).length>0&&(n.userData=this.userData);function s(r){const o=[];for(const a in r){const l=r[a];delete l.metadata,o.push(l)}return o}if(t){const r=s(e.textures),o=s(e.images);r.length>0&&(n.textures=r),o.length>0&&(n.images=o)}return n}clone(){return new this.constructor().copy(this)}copy(e){this.name=e.name,this.blending=e.blending,this.side=e.side,this.vertexColors=e.vertexColors,this.opacity=e.opacity,this.transparent=e.transparent,this.blendSrc=e.blendSrc,this.blendDst=e.blendDst,this.blendEquation=e.blendEquation,this.blendSrcAlpha=e.blendSrcAlpha,this.blendDstAlpha=e.blendDstAlpha,this.blendEquationAlpha=e.blendEquationAlpha,this.blendColor.copy(e.blendColor),this.blendAlpha=e.blendAlpha,this.depthFunc=e.depthFunc,this.depthTest=e.depthTest,this.depthWrite=e.depthWrite,this.stencilWriteMask=e.stencilWriteMask,this.stencilFunc=e.stencilFunc,this.stencilRef=e.stencilRef,this.stencilFuncMask=e.stencilFuncMask,this.stencilFail=e.stencilFail,this.stencilZFail=e.stencilZFail,this.stencilZPass=e.stencilZPass,this.stencilWrite=e.stencilWrite;const t=e.clippingPlanes;let n=null;if(t!==null){const s=t.length;n=new Array(s);for(let r=0;r!==s;++r)n[r]=t[r].clone()}return this.clippingPlanes=n,this.clipIntersection=e.clipIntersection,this.clipShadows=e.clipShadows,this.shadowSide=e.shadowSide,this.colorWrite=e.colorWrite,this.precision=e.precision,this.polygonOffset=e.polygonOffset,this.polygonOffsetFactor=e.polygonOffsetFactor,this.polygonOffsetUnits=e.polygonOffsetUnits,this.dithering=e.dithering,this.alphaTest=e.alphaTest,this.alphaHash=e.alphaHash,this.alphaToCoverage=e.alphaToCoverage,this.premultipliedAlpha=e.premultipliedAlpha,this.forceSinglePass=e.forceSinglePass,this.visible=e.visible,this.toneMapped=e.toneMapped,this.userData=JSON.parse(JSON.stringify(e.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(e){e===!0&&this.version++}onBuild(){console.warn("Material: onBuild() has been removed.")}}class xu extends Or{static get type(){return"MeshBasicMaterial"}constructor(e){super(),this.isMeshBasicMaterial=!0,this.color=new at(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Si,this.combine=Qf,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.specularMap=e.specularMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.combine=e.combine,this.reflectivity=e.reflectivity,this.refractionRatio=e.refractionRatio,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.fog=e.fog,this}}const Xt=new Y,$o=new mt;class xi{constructor(e,t,n=!1){if(Array.isArray(e))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,this.name="",this.array=e,this.itemSize=t,this.count=e!==void 0?e.length/t:0,this.normalized=n,this.usage=Xh,this.updateRanges=[],this.gpuType=Ii,this.version=0}onUploadCallback(){}set needsUpdate(e){e===!0&&this.version++}setUsage(e){return this.usage=e,this}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}copy(e){return this.name=e.name,this.array=new e.array.constructor(e.array),this.itemSize=e.itemSize,this.count=e.count,this.normalized=e.normalized,this.usage=e.usage,this.gpuType=e.gpuType,this}copyAt(e,t,n){e*=this.itemSize,n*=t.itemSize;for(let s=0,r=this.itemSize;s<r;s++)this.array[e+s]=t.array[n+s];return this}copyArray(e){return this.array.set(e),this}applyMatrix3(e){if(this.itemSize===2)for(let t=0,n=this.count;t<n;t++)$o.fromBufferAttribute(this,t),$o.applyMatrix3(e),this.setXY(t,$o.x,$o.y);else if(this.itemSize===3)for(let t=0,n=this.count;t<n;t++)Xt.fromBufferAttribute(this,t),Xt.applyMatrix3(e),this.setXYZ(t,Xt.x,Xt.y,Xt.z);return this}applyMatrix4(e){for(let t=0,n=this.count;t<n;t++)Xt.fromBufferAttribute(this,t),Xt.applyMatrix4(e),this.setXYZ(t,Xt.x,Xt.y,Xt.z);return this}applyNormalMatrix(e){for(let t=0,n=this.count;t<n;t++)Xt.fromBufferAttribute(this,t),Xt.applyNormalMatrix(e),this.setXYZ(t,Xt.x,Xt.y,Xt.z);return this}transformDirection(e){for(let t=0,n=this.count;t<n;t++)Xt.fromBufferAttribute(this,t),Xt.transformDirection(e),this.setXYZ(t,Xt.x,Xt.y,Xt.z);return this}set(e,t=0){return this.array.set(e,t),this}getComponent(e,t){let n=this.array[e*this.itemSize+t];return this.normalized&&(n=Yr(n,this.array)),n}setComponent(e,t,n){return this.normalized&&(n=wn(n,this.array)),this.array[e*this.itemSize+t]=n,this}getX(e){let t=this.array[e*this.itemSize];return this.normalized&&(t=Yr(t,this.array)),t}setX(e,t){return this.normalized&&(t=wn(t,this.array)),this.array[e*this.itemSize]=t,this}getY(e){let t=this.array[e*this.itemSize+1];return this.normalized&&(t=Yr(t,this.array)),t}setY(e,t){return this.normalized&&(t=wn(t,this.array)),this.array[e*this.itemSize+1]=t,this}getZ(e){let t=this.array[e*this.itemSize+2];return this.normalized&&(t=Yr(t,this.array)),t}setZ(e,t){return this.normalized&&(t=wn(t,this.array)),this.array[e*this.itemSize+2]=t,this}getW(e){let t=this.array[e*this.itemSize+3];return this.normalized&&(t=Yr(t,this.array)),t}setW(e,t){return this.normalized&&(t=wn(t,this.array)),this.array[e*this.itemSize+3]=t,this}setXY(e,t,n){return e*=this.itemSize,this.normalized&&(t=wn(t,this.array),n=wn(n,this.array)),this.array[e+0]=t,this.array[e+1]=n,this}setXYZ(e,t,n,s){return e*=this.itemSize,this.normalized&&(t=wn(t,this.array),n=wn(n,this.array),s=wn(s,this.array)),this.array[e+0]=t,this.array[e+1]=n,this.array[e+2]=s,this}setXYZW(e,t,n,s,r){return e*=this.itemSize,this.normalized&&(t=wn(t,this.array),n=wn(n,this.array),s=wn(s,this.array),r=wn(r,this.array)),this.array[e+0]=t,this.array[e+1]=n,this.array[e+2]=s,this.array[e+3]=r,this}onUpload(e){return this.onUploadCallback=e,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){const e={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return this.name!==""&&(e.name=this.name),this.usage!==Xh&&(e.usage=this.usage),e}}class _p extends xi{constructor(e,t,n){super(new Uint16Array(e),t,n)}}class vp extends xi{constructor(e,t,n){super(new Uint32Array(e),t,n)}}class qn extends xi{constructor(e,t,n){super(new Float32Array(e),t,n)}}let ME=0;const Vn=new Bt,Rl=new Jt,lr=new Y,Nn=new So,Jr=new So,ln=new Y;class yi extends Fr{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:ME++}),this.uuid=xo(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={}}getIndex(){return this.index}setIndex(e){return Array.isArray(e)?this.index=new(fp(e)?vp:_p)(e,1):this.index=e,this}setIndirect(e){return this.indirect=e,this}getIndirect(){return this.indirect}getAttribute(e){return this.attributes[e]}setAttribute(e,t){return this.attributes[e]=t,this}deleteAttribute(e){return delete this.attributes[e],this}hasAttribute(e){return this.attributes[e]!==void 0}addGroup(e,t,n=0){this.groups.push({start:e,count:t,materialIndex:n})}clearGroups(){this.groups=[]}setDrawRange(e,t){this.drawRange.start=e,this.drawRange.count=t}applyMatrix4(e){const t=this.attributes.position;t!==void 0&&(t.applyMatrix4(e),t.needsUpdate=!0);const n=this.attributes.normal;if(n!==void 0){const r=new et().getNormalMatrix(e);n.applyNormalMatrix(r),n.needsUpdate=!0}const s=this.attributes.tangent;return s!==void 0&&(s.transformDirection(e),s.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this}applyQuaternion(e){return Vn.makeRotationFromQuaternion(e),this.applyMatrix4(Vn),this}rotateX(e){return Vn.makeRotationX(e),this.applyMatrix4(Vn),this}rotateY(e){return Vn.makeRotationY(e),this.applyMatrix4(Vn),this}rotateZ(e){return Vn.makeRotationZ(e),this.applyMatrix4(Vn),this}translate(e,t,n){return Vn.makeTranslation(e,t,n),this.applyMatrix4(Vn),this}scale(e,t,n){return Vn.makeScale(e,t,n),this.applyMatrix4(Vn),this}lookAt(e){return Rl.lookAt(e),Rl.updateMatrix(),this.applyMatrix4(Rl.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(lr).negate(),this.translate(lr.x,lr.y,lr.z),this}setFromPoints(e){const t=this.getAttribute("position");if(t===void 0){const n=[];for(let s=0,r=e.length;s<r;s++){const o=e[s];n.push(o.x,o.y,o.z||0)}this.setAttribute("position",new qn(n,3))}else{for(let n=0,s=t.count;n<s;n++){const r=e[n];t.setXYZ(n,r.x,r.y,r.z||0)}e.length>t.count&&console.warn("THREE.BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),t.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new So);const e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){console.error("THREE.BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new Y(-1/0,-1/0,-1/0),new Y(1/0,1/0,1/0));return}if(e!==void 0){if(this.boundingBox.setFromBufferAttribute(e),t)for(let n=0,s=t.length;n<s;n++){const r=t[n];Nn.setFromBufferAttribute(r),this.morphTargetsRelative?(ln.addVectors(this.boundingBox.min,Nn.min),this.boundingBox.expandByPoint(ln),ln.addVectors(this.boundingBox.max,Nn.max),this.boundingBox.expandByPoint(ln)):(this.boundingBox.expandByPoint(Nn.min),this.boundingBox.expandByPoint(Nn.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&console.error('THREE.BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new za);const e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){console.error("THREE.BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new Y,1/0);return}if(e){const n=this.boundingSphere.center;if(Nn.setFromBufferAttribute(e),t)for(let r=0,o=t.length;r<o;r++){const a=t[r];Jr.setFromBufferAttribute(a),this.morphTargetsRelative?(ln.addVectors(Nn.min,Jr.min),Nn.expandByPoint(ln),ln.addVectors(Nn.max,Jr.max),Nn.expandByPoint(ln)):(Nn.expandByPoint(Jr.min),Nn.expandByPoint(Jr.max))}Nn.getCenter(n);let s=0;for(let r=0,o=e.count;r<o;r++)ln.fromBufferAttribute(e,r),s=Math.max(s,n.distanceToSquared(ln));if(t)for(let r=0,o=t.length;r<o;r++){const a=t[r],l=this.morphTargetsRelative;for(let c=0,u=a.count;c<u;c++)ln.fromBufferAttribute(a,c),l&&(lr.fromBufferAttribute(e,c),ln.add(lr)),s=Math.max(s,n.distanceToSquared(ln))}this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&console.error('THREE.BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){const e=this.index,t=this.attributes;if(e===null||t.position===void 0||t.normal===void 0||t.uv===void 0){console.error("THREE.BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}const n=t.position,s=t.normal,r=t.uv;this.hasAttribute("tangent")===!1&&this.setAttribute("tangent",new xi(new Float32Array(4*n.count),4));const o=this.getAttribute("tangent"),a=[],l=[];for(let N=0;N<n.count;N++)a[N]=new Y,l[N]=new Y;const c=new Y,u=new Y,h=new Y,d=new mt,m=new mt,_=new mt,v=new Y,p=new Y;function f(N,w,y){c.fromBufferAttribute(n,N),u.fromBufferAttribute(n,w),h.fromBufferAttribute(n,y),d.fromBufferAttribute(r,N),m.fromBufferAttribute(r,w),_.fromBufferAttribute(r,y),u.sub(c),h.sub(c),m.sub(d),_.sub(d);const R=1/(m.x*_.y-_.x*m.y);isFinite(R)&&(v.copy(u).multiplyScalar(_.y).addScaledVector(h,-m.y).multiplyScalar(R),p.copy(h).multiplyScalar(m.x).addScaledVector(u,-_.x).multiplyScalar(R),a[N].add(v),a[w].add(v),a[y].add(v),l[N].add(p),l[w].add(p),l[y].add(p))}let E=this.groups;E.length===0&&(E=[{start:0,count:e.count}]);for(let N=0,w=E.length;N<w;++N){const y=E[N],R=y.start,V=y.count;for(let U=R,K=R+V;U<K;U+=3)f(e.getX(U+0),e.getX(U+1),e.getX(U+2))}const T=new Y,M=new Y,k=new Y,L=new Y;function D(N){k.fromBufferAttribute(s,N),L.copy(k);const w=a[N];T.copy(w),T.sub(k.multiplyScalar(k.dot(w))).normalize(),M.crossVectors(L,w);const R=M.dot(l[N])<0?-1:1;o.setXYZW(N,T.x,T.y,T.z,R)}for(let N=0,w=E.length;N<w;++N){const y=E[N],R=y.start,V=y.count;for(let U=R,K=R+V;U<K;U+=3)D(e.getX(U+0)),D(e.getX(U+1)),D(e.getX(U+2))}}computeVertexNormals(){const e=this.index,t=this.getAttribute("position");if(t!==void 0){let n=this.getAttribute("normal");if(n===void 0)n=new xi(new Float32Array(t.count*3),3),this.setAttribute("normal",n);else for(let d=0,m=n.count;d<m;d++)n.setXYZ(d,0,0,0);const s=new Y,r=new Y,o=new Y,a=new Y,l=new Y,c=new Y,u=new Y,h=new Y;if(e)for(let d=0,m=e.count;d<m;d+=3){const _=e.getX(d+0),v=e.getX(d+1),p=e.getX(d+2);s.fromBufferAttribute(t,_),r.fromBufferAttribute(t,v),o.fromBufferAttribute(t,p),u.subVectors(o,r),h.subVectors(s,r),u.cross(h),a.fromBufferAttribute(n,_),l.fromBufferAttribute(n,v),c.fromBufferAttribute(n,p),a.add(u),l.add(u),c.add(u),n.setXYZ(_,a.x,a.y,a.z),n.setXYZ(v,l.x,l.y,l.z),n.setXYZ(p,c.x,c.y,c.z)}else for(let d=0,m=t.count;d<m;d+=3)s.fromBufferAttribute(t,d+0),r.fromBufferAttribute(t,d+1),o.fromBufferAttribute(t,d+2),u.subVectors(o,r),h.subVectors(s,r),u.cross(h),n.setXYZ(d+0,u.x,u.y,u.z),n.setXYZ(d+1,u.x,u.y,u.z),n.setXYZ(d+2,u.x,u.y,u.z);this.normalizeNormals(),n.needsUpdate=!0}}normalizeNormals(){const e=this.attributes.normal;for(let t=0,n=e.count;t<n;t++)ln.fromBufferAttribute(e,t),ln.normalize(),e.setXYZ(t,ln.x,ln.y,ln.z)}toNonIndexed(){function e(a,l){const c=a.array,u=a.itemSize,h=a.normalized,d=new c.constructor(l.length*u);let m=0,_=0;for(let v=0,p=l.length;v<p;v++){a.isInterleavedBufferAttribute?m=l[v]*a.data.stride+a.offset:m=l[v]*u;for(let f=0;f<u;f++)d[_++]=c[m++]}return new xi(d,u,h)}if(this.index===null)return console.warn("THREE.BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;const t=new yi,n=this.index.array,s=this.attributes;for(const a in s){const l=s[a],c=e(l,n);t.setAttribute(a,c)}const r=this.morphAttributes;for(const a in r){const l=[],c=r[a];for(let u=0,h=c.length;u<h;u++){const d=c[u],m=e(d,n);l.push(m)}t.morphAttributes[a]=l}t.morphTargetsRelative=this.morphTargetsRelative;const o=this.groups;for(let a=0,l=o.length;a<l;a++){const c=o[a];t.addGroup(c.start,c.count,c.materialIndex)}return t}toJSON(){const e={metadata:{version:4.6,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(e.uuid=this.uuid,e.type=this.type,this.name!==""&&(e.name=this.name),Object.keys(this.userData).length>0&&(e.userData=this.userData),this.parameters!==void 0){const l=this.parameters;for(const c in l)l[c]!==void 0&&(e[c]=l[c]);return e}e.data={attributes:{}};const t=this.index;t!==null&&(e.data.index={type:t.array.constructor.name,array:Array.prototype.slice.call(t.array)});const n=this.attributes;for(const l in n){const c=n[l];e.data.attributes[l]=c.toJSON(e.data)}const s={};let r=!1;for(const l in this.morphAttributes){const c=this.morphAttributes[l],u=[];for(let h=0,d=c.length;h<d;h++){const m=c[h];u.push(m.toJSON(e.data))}u.length>0&&(s[l]=u,r=!0)}r&&(e.data.morphAttributes=s,e.data.morphTargetsRelative=this.morphTargetsRelative);const o=this.groups;o.length>0&&(e.data.groups=JSON.parse(JSON.stringify(o)));const a=this.boundingSphere;return a!==null&&(e.data.boundingSphere={center:a.center.toArray(),radius:a.radius}),e}clone(){return new this.constructor().copy(this)}copy(e){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;const t={};this.name=e.name;const n=e.index;n!==null&&this.setIndex(n.clone(t));const s=e.attributes;for(const c in s){const u=s[c];this.setAttribute(c,u.clone(t))}const r=e.morphAttributes;for(const c in r){const u=[],h=r[c];for(let d=0,m=h.length;d<m;d++)u.push(h[d].clone(t));this.morphAttributes[c]=u}this.morphTargetsRelative=e.morphTargetsRelative;const o=e.groups;for(let c=0,u=o.length;c<u;c++){const h=o[c];this.addGroup(h.start,h.count,h.materialIndex)}const a=e.boundingBox;a!==null&&(this.boundingBox=a.clone());const l=e.boundingSphere;return l!==null&&(this.boundingSphere=l.clone()),this.drawRange.start=e.drawRange.start,this.drawRange.count=e.drawRange.count,this.userData=e.userData,this}dispose(){this.dispatchEvent({type:"dispose"})}}const cd=new Bt,ms=new _u,Xo=new za,ud=new Y,qo=new Y,Yo=new Y,jo=new Y,Cl=new Y,Ko=new Y,hd=new Y,Zo=new Y;class pn extends Jt{constructor(e=new yi,t=new xu){super(),this.isMesh=!0,this.type="Mesh",this.geometry=e,this.material=t,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0&&(this.morphTargetInfluences=e.morphTargetInfluences.slice()),e.morphTargetDictionary!==void 0&&(this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary)),this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}updateMorphTargets(){const t=this.geometry.morphAttributes,n=Object.keys(t);if(n.length>0){const s=t[n[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){const a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}getVertexPosition(e,t){const n=this.geometry,s=n.attributes.position,r=n.morphAttributes.position,o=n.morphTargetsRelative;t.fromBufferAttribute(s,e);const a=this.morphTargetInfluences;if(r&&a){Ko.set(0,0,0);for(let l=0,c=r.length;l<c;l++){const u=a[l],h=r[l];u!==0&&(Cl.fromBufferAttribute(h,e),o?Ko.addScaledVector(Cl,u):Ko.addScaledVector(Cl.sub(t),u))}t.add(Ko)}return t}raycast(e,t){const n=this.geometry,s=this.material,r=this.matrixWorld;s!==void 0&&(n.boundingSphere===null&&n.computeBoundingSphere(),Xo.copy(n.boundingSphere),Xo.applyMatrix4(r),ms.copy(e.ray).recast(e.near),!(Xo.containsPoint(ms.origin)===!1&&(ms.intersectSphere(Xo,ud)===null||ms.origin.distanceToSquared(ud)>(e.far-e.near)**2))&&(cd.copy(r).invert(),ms.copy(e.ray).applyMatrix4(cd),!(n.boundingBox!==null&&ms.intersectsBox(n.boundingBox)===!1)&&this._computeIntersections(e,t,ms)))}_computeIntersections(e,t,n){let s;const r=this.geometry,o=this.material,a=r.index,l=r.attributes.position,c=r.attributes.uv,u=r.attributes.uv1,h=r.attributes.normal,d=r.groups,m=r.drawRange;if(a!==null)if(Array.isArray(o))for(let _=0,v=d.length;_<v;_++){const p=d[_],f=o[p.materialIndex],E=Math.max(p.start,m.start),T=Math.min(a.count,Math.min(p.start+p.count,m.start+m.count));for(let M=E,k=T;M<k;M+=3){const L=a.getX(M),D=a.getX(M+1),N=a.getX(M+2);s=Jo(this,f,e,n,c,u,h,L,D,N),s&&(s.faceIndex=Math.floor(M/3),s.face.materialIndex=p.materialIndex,t.push(s))}}else{const _=Math.max(0,m.start),v=Math.min(a.count,m.start+m.count);for(let p=_,f=v;p<f;p+=3){const E=a.getX(p),T=a.getX(p+1),M=a.getX(p+2);s=Jo(this,o,e,n,c,u,h,E,T,M),s&&(s.faceIndex=Math.floor(p/3),t.push(s))}}else if(l!==void 0)if(Array.isArray(o))for(let _=0,v=d.length;_<v;_++){const p=d[_],f=o[p.materialIndex],E=Math.max(p.start,m.start),T=Math.min(l.count,Math.min(p.start+p.count,m.start+m.count));for(let M=E,k=T;M<k;M+=3){const L=M,D=M+1,N=M+2;s=Jo(this,f,e,n,c,u,h,L,D,N),s&&(s.faceIndex=Math.floor(M/3),s.face.materialIndex=p.materialIndex,t.push(s))}}else{const _=Math.max(0,m.start),v=Math.min(l.count,m.start+m.count);for(let p=_,f=v;p<f;p+=3){const E=p,T=p+1,M=p+2;s=Jo(this,o,e,n,c,u,h,E,T,M),s&&(s.faceIndex=Math.floor(p/3),t.push(s))}}}}function SE(i,e,t,n,s,r,o,a){let l;if(e.side===An?l=n.intersectTriangle(o,r,s,!0,a):l=n.intersectTriangle(s,r,o,e.side===rs,a),l===null)return null;Zo.copy(a),Zo.applyMatrix4(i.matrixWorld);const c=t.ray.origin.distanceTo(Zo);return c<t.near||c>t.far?null:{distance:c,point:Zo.clone(),object:i}}function Jo(i,e,t,n,s,r,o,a,l,c){i.getVertexPosition(a,qo),i.getVertexPosition(l,Yo),i.getVertexPosition(c,jo);const u=SE(i,e,t,n,qo,Yo,jo,hd);if(u){const h=new Y;ii.getBarycoord(hd,qo,Yo,jo,h),s&&(u.uv=ii.getInterpolatedAttribute(s,a,l,c,h,new mt)),r&&(u.uv1=ii.getInterpolatedAttribute(r,a,l,c,h,new mt)),o&&(u.normal=ii.getInterpolatedAttribute(o,a,l,c,h,new Y),u.normal.dot(n.direction)>0&&u.normal.multiplyScalar(-1));const d={a,b:l,c,normal:new Y,materialIndex:0};ii.getNormal(qo,Yo,jo,d.normal),u.face=d,u.barycoord=h}return u}class Os extends yi{constructor(e=1,t=1,n=1,s=1,r=1,o=1){super(),this.type="BoxGeometry",this.parameters={width:e,height:t,depth:n,widthSegments:s,heightSegments:r,depthSegments:o};const a=this;s=Math.floor(s),r=Math.floor(r),o=Math.floor(o);const l=[],c=[],u=[],h=[];let d=0,m=0;_("z","y","x",-1,-1,n,t,e,o,r,0),_("z","y","x",1,-1,n,t,-e,o,r,1),_("x","z","y",1,1,e,n,t,s,o,2),_("x","z","y",1,-1,e,n,-t,s,o,3),_("x","y","z",1,-1,e,t,n,s,r,4),_("x","y","z",-1,-1,e,t,-n,s,r,5),this.setIndex(l),this.setAttribute("position",new qn(c,3)),this.setAttribute("normal",new qn(u,3)),this.setAttribute("uv",new qn(h,2));function _(v,p,f,E,T,M,k,L,D,N,w){const y=M/D,R=k/N,V=M/2,U=k/2,K=L/2,X=D+1,Q=N+1;let J=0,ne=0;const fe=new Y;for(let he=0;he<Q;he++){const _e=he*R-U;for(let ye=0;ye<X;ye++){const ge=ye*y-V;fe[v]=ge*E,fe[p]=_e*T,fe[f]=K,c.push(fe.x,fe.y,fe.z),fe[v]=0,fe[p]=0,fe[f]=L>0?1:-1,u.push(fe.x,fe.y,fe.z),h.push(ye/D),h.push(1-he/N),J+=1}}for(let he=0;he<N;he++)for(let _e=0;_e<D;_e++){const ye=d+_e+X*he,ge=d+_e+X*(he+1),re=d+(_e+1)+X*(he+1),ce=d+(_e+1)+X*he;l.push(ye,ge,ce),l.push(ge,re,ce),ne+=6}a.addGroup(m,ne,w),m+=ne,d+=J}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new Os(e.width,e.height,e.depth,e.widthSegments,e.heightSegments,e.depthSegments)}}function Pr(i){const e={};for(const t in i){e[t]={};for(const n in i[t]){const s=i[t][n];s&&(s.isColor||s.isMatrix3||s.isMatrix4||s.isVector2||s.isVector3||s.isVector4||s.isTexture||s.isQuaternion)?s.isRenderTargetTexture?(console.warn("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),e[t][n]=null):e[t][n]=s.clone():Array.isArray(s)?e[t][n]=s.slice():e[t][n]=s}}return e}function Mn(i){const e={};for(let t=0;t<i.length;t++){const n=Pr(i[t]);for(const s in n)e[s]=n[s]}return e}function yE(i){const e=[];for(let t=0;t<i.length;t++)e.push(i[t].clone());return e}function xp(i){const e=i.getRenderTarget();return e===null?i.outputColorSpace:e.isXRRenderTarget===!0?e.texture.colorSpace:pt.workingColorSpace}const bE={clone:Pr,merge:Mn};var EE=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,wE=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`;class os extends Or{static get type(){return"ShaderMaterial"}constructor(e){super(),this.isShaderMaterial=!0,this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=EE,this.fragmentShader=wE,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,e!==void 0&&this.setValues(e)}copy(e){return super.copy(e),this.fragmentShader=e.fragmentShader,this.vertexShader=e.vertexShader,this.uniforms=Pr(e.uniforms),this.uniformsGroups=yE(e.uniformsGroups),this.defines=Object.assign({},e.defines),this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.fog=e.fog,this.lights=e.lights,this.clipping=e.clipping,this.extensions=Object.assign({},e.extensions),this.glslVersion=e.glslVersion,this}toJSON(e){const t=super.toJSON(e);t.glslVersion=this.glslVersion,t.uniforms={};for(const s in this.uniforms){const o=this.uniforms[s].value;o&&o.isTexture?t.uniforms[s]={type:"t",value:o.toJSON(e).uuid}:o&&o.isColor?t.uniforms[s]={type:"c",value:o.getHex()}:o&&o.isVector2?t.uniforms[s]={type:"v2",value:o.toArray()}:o&&o.isVector3?t.uniforms[s]={type:"v3",value:o.toArray()}:o&&o.isVector4?t.uniforms[s]={type:"v4",value:o.toArray()}:o&&o.isMatrix3?t.uniforms[s]={type:"m3",value:o.toArray()}:o&&o.isMatrix4?t.uniforms[s]={type:"m4",value:o.toArray()}:t.uniforms[s]={value:o}}Object.keys(this.defines).length>0&&(t.defines=this.defines),t.vertexShader=this.vertexShader,t.fragmentShader=this.fragmentShader,t.lights=this.lights,t.clipping=this.clipping;const n={};for(const s in this.extensions)this.extensions[s]===!0&&(n[s]=!0);return Object.keys(n).length>0&&(t.extensions=n),t}}class Mp extends Jt{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new Bt,this.projectionMatrix=new Bt,this.projectionMatrixInverse=new Bt,this.coordinateSystem=Ui}copy(e,t){return super.copy(e,t),this.matrixWorldInverse.copy(e.matrixWorldInverse),this.projectionMatrix.copy(e.projectionMatrix),this.projectionMatrixInverse.copy(e.projectionMatrixInverse),this.coordinateSystem=e.coordinateSystem,this}getWorldDirection(e){return super.getWorldDirection(e).negate()}updateMatrixWorld(e){super.updateMatrixWorld(e),this.matrixWorldInverse.copy(this.matrixWorld).invert()}updateWorldMatrix(e,t){super.updateWorldMatrix(e,t),this.matrixWorldInverse.copy(this.matrixWorld).invert()}clone(){return new this.constructor().copy(this)}}const Ki=new Y,dd=new mt,fd=new mt;class Xn extends Mp{constructor(e=50,t=1,n=.1,s=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=e,this.zoom=1,this.near=n,this.far=s,this.focus=10,this.aspect=t,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.fov=e.fov,this.zoom=e.zoom,this.near=e.near,this.far=e.far,this.focus=e.focus,this.aspect=e.aspect,this.view=e.view===null?null:Object.assign({},e.view),this.filmGauge=e.filmGauge,this.filmOffset=e.filmOffset,this}setFocalLength(e){const t=.5*this.getFilmHeight()/e;this.fov=zc*2*Math.atan(t),this.updateProjectionMatrix()}getFocalLength(){const e=Math.tan(cl*.5*this.fov);return .5*this.getFilmHeight()/e}getEffectiveFOV(){return zc*2*Math.atan(Math.tan(cl*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(e,t,n){Ki.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),t.set(Ki.x,Ki.y).multiplyScalar(-e/Ki.z),Ki.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),n.set(Ki.x,Ki.y).multiplyScalar(-e/Ki.z)}getViewSize(e,t){return this.getViewBounds(e,dd,fd),t.subVectors(fd,dd)}setViewOffset(e,t,n,s,r,o){this.aspect=e/t,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=n,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){const e=this.near;let t=e*Math.tan(cl*.5*this.fov)/this.zoom,n=2*t,s=this.aspect*n,r=-.5*s;const o=this.view;if(this.view!==null&&this.view.enabled){const l=o.fullWidth,c=o.fullHeight;r+=o.offsetX*s/l,t-=o.offsetY*n/c,s*=o.width/l,n*=o.height/c}const a=this.filmOffset;a!==0&&(r+=e*a/this.getFilmWidth()),this.projectionMatrix.makePerspective(r,r+s,t,t-n,e,this.far,this.coordinateSystem),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){const t=super.toJSON(e);return t.object.fov=this.fov,t.object.zoom=this.zoom,t.object.near=this.near,t.object.far=this.far,t.object.focus=this.focus,t.object.aspect=this.aspect,this.view!==null&&(t.object.view=Object.assign({},this.view)),t.object.filmGauge=this.filmGauge,t.object.filmOffset=this.filmOffset,t}}const cr=-90,ur=1;class TE extends Jt{constructor(e,t,n){super(),this.type="CubeCamera",this.renderTarget=n,this.coordinateSystem=null,this.activeMipmapLevel=0;const s=new Xn(cr,ur,e,t);s.layers=this.layers,this.add(s);const r=new Xn(cr,ur,e,t);r.layers=this.layers,this.add(r);const o=new Xn(cr,ur,e,t);o.layers=this.layers,this.add(o);const a=new Xn(cr,ur,e,t);a.layers=this.layers,this.add(a);const l=new Xn(cr,ur,e,t);l.layers=this.layers,this.add(l);const c=new Xn(cr,ur,e,t);c.layers=this.layers,this.add(c)}updateCoordinateSystem(){const e=this.coordinateSystem,t=this.children.concat(),[n,s,r,o,a,l]=t;for(const c of t)this.remove(c);if(e===Ui)n.up.set(0,1,0),n.lookAt(1,0,0),s.up.set(0,1,0),s.lookAt(-1,0,0),r.up.set(0,0,-1),r.lookAt(0,1,0),o.up.set(0,0,1),o.lookAt(0,-1,0),a.up.set(0,1,0),a.lookAt(0,0,1),l.up.set(0,1,0),l.lookAt(0,0,-1);else if(e===ya)n.up.set(0,-1,0),n.lookAt(-1,0,0),s.up.set(0,-1,0),s.lookAt(1,0,0),r.up.set(0,0,1),r.lookAt(0,1,0),o.up.set(0,0,-1),o.lookAt(0,-1,0),a.up.set(0,-1,0),a.lookAt(0,0,1),l.up.set(0,-1,0),l.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+e);for(const c of t)this.add(c),c.updateMatrixWorld()}update(e,t){this.parent===null&&this.updateMatrixWorld();const{renderTarget:n,activeMipmapLevel:s}=this;this.coordinateSystem!==e.coordinateSystem&&(this.coordinateSystem=e.coordinateSystem,this.updateCoordinateSystem());const[r,o,a,l,c,u]=this.children,h=e.getRenderTarget(),d=e.getActiveCubeFace(),m=e.getActiveMipmapLevel(),_=e.xr.enabled;e.xr.enabled=!1;const v=n.texture.generateMipmaps;n.texture.generateMipmaps=!1,e.setRenderTarget(n,0,s),e.render(t,r),e.setRenderTarget(n,1,s),e.render(t,o),e.setRenderTarget(n,2,s),e.render(t,a),e.setRenderTarget(n,3,s),e.render(t,l),e.setRenderTarget(n,4,s),e.render(t,c),n.texture.generateMipmaps=v,e.setRenderTarget(n,5,s),e.render(t,u),e.setRenderTarget(h,d,m),e.xr.enabled=_,n.texture.needsPMREMUpdate=!0}}class Sp extends yn{constructor(e,t,n,s,r,o,a,l,c,u){e=e!==void 0?e:[],t=t!==void 0?t:Tr,super(e,t,n,s,r,o,a,l,c,u),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(e){this.image=e}}class AE extends Fs{constructor(e=1,t={}){super(e,e,t),this.isWebGLCubeRenderTarget=!0;const n={width:e,height:e,depth:1},s=[n,n,n,n,n,n];this.texture=new Sp(s,t.mapping,t.wrapS,t.wrapT,t.magFilter,t.minFilter,t.format,t.type,t.anisotropy,t.colorSpace),this.texture.isRenderTargetTexture=!0,this.texture.generateMipmaps=t.generateMipmaps!==void 0?t.generateMipmaps:!1,this.texture.minFilter=t.minFilter!==void 0?t.minFilter:vi}fromEquirectangularTexture(e,t){this.texture.type=t.type,this.texture.colorSpace=t.colorSpace,this.texture.generateMipmaps=t.generateMipmaps,this.texture.minFilter=t.minFilter,this.texture.magFilter=t.magFilter;const n={uniforms:{tEquirect:{value:null}},vertexShader:`

				varying vec3 vWorldDirection;

				vec3 transformDirection( in vec3 dir, in mat4 matrix ) {

					return normalize( ( matrix * vec4( dir, 0.0 ) ).xyz );

				}

				void main() {

					vWorldDirection = transformDirection( position, modelMatrix );

					#include <begin_vertex>
					#include <project_vertex>

				}
			`,fragmentShader:`

				uniform sampler2D tEquirect;

				varying vec3 vWorldDirection;

				#include <common>

				void main() {

					vec3 direction = normalize( vWorldDirection );

					vec2 sampleUV = equirectUv( direction );

					gl_FragColor = texture2D( tEquirect, sampleUV );

				}
			`},s=new Os(5,5,5),r=new os({name:"CubemapFromEquirect",uniforms:Pr(n.uniforms),vertexShader:n.vertexShader,fragmentShader:n.fragmentShader,side:An,blending:ns});r.uniforms.tEquirect.value=t;const o=new pn(s,r),a=t.minFilter;return t.minFilter===Rs&&(t.minFilter=vi),new TE(1,10,this).update(e,o),t.minFilter=a,o.geometry.dispose(),o.material.dispose(),this}clear(e,t,n,s){const r=e.getRenderTarget();for(let o=0;o<6;o++)e.setRenderTarget(this,o),e.clear(t,n,s);e.setRenderTarget(r)}}const Pl=new Y,RE=new Y,CE=new et;class Qi{constructor(e=new Y(1,0,0),t=0){this.isPlane=!0,this.normal=e,this.constant=t}set(e,t){return this.normal.copy(e),this.constant=t,this}setComponents(e,t,n,s){return this.normal.set(e,t,n),this.constant=s,this}setFromNormalAndCoplanarPoint(e,t){return this.normal.copy(e),this.constant=-t.dot(this.normal),this}setFromCoplanarPoints(e,t,n){const s=Pl.subVectors(n,t).cross(RE.subVectors(e,t)).normalize();return this.setFromNormalAndCoplanarPoint(s,e),this}copy(e){return this.normal.copy(e.normal),this.constant=e.constant,this}normalize(){const e=1/this.normal.length();return this.normal.multiplyScalar(e),this.constant*=e,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(e){return this.normal.dot(e)+this.constant}distanceToSphere(e){return this.distanceToPoint(e.center)-e.radius}projectPoint(e,t){return t.copy(e).addScaledVector(this.normal,-this.distanceToPoint(e))}intersectLine(e,t){const n=e.delta(Pl),s=this.normal.dot(n);if(s===0)return this.distanceToPoint(e.start)===0?t.copy(e.start):null;const r=-(e.start.dot(this.normal)+this.constant)/s;return r<0||r>1?null:t.copy(e.start).addScaledVector(n,r)}intersectsLine(e){const t=this.distanceToPoint(e.start),n=this.distanceToPoint(e.end);return t<0&&n>0||n<0&&t>0}intersectsBox(e){return e.intersectsPlane(this)}intersectsSphere(e){return e.intersectsPlane(this)}coplanarPoint(e){return e.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(e,t){const n=t||CE.getNormalMatrix(e),s=this.coplanarPoint(Pl).applyMatrix4(e),r=this.normal.applyMatrix3(n).normalize();return this.constant=-s.dot(r),this}translate(e){return this.constant-=e.dot(this.normal),this}equals(e){return e.normal.equals(this.normal)&&e.constant===this.constant}clone(){return new this.constructor().copy(this)}}const gs=new za,Qo=new Y;class Mu{constructor(e=new Qi,t=new Qi,n=new Qi,s=new Qi,r=new Qi,o=new Qi){this.planes=[e,t,n,s,r,o]}set(e,t,n,s,r,o){const a=this.planes;return a[0].copy(e),a[1].copy(t),a[2].copy(n),a[3].copy(s),a[4].copy(r),a[5].copy(o),this}copy(e){const t=this.planes;for(let n=0;n<6;n++)t[n].copy(e.planes[n]);return this}setFromProjectionMatrix(e,t=Ui){const n=this.planes,s=e.elements,r=s[0],o=s[1],a=s[2],l=s[3],c=s[4],u=s[5],h=s[6],d=s[7],m=s[8],_=s[9],v=s[10],p=s[11],f=s[12],E=s[13],T=s[14],M=s[15];if(n[0].setComponents(l-r,d-c,p-m,M-f).normalize(),n[1].setComponents(l+r,d+c,p+m,M+f).normalize(),n[2].setComponents(l+o,d+u,p+_,M+E).normalize(),n[3].setComponents(l-o,d-u,p-_,M-E).normalize(),n[4].setComponents(l-a,d-h,p-v,M-T).normalize(),t===Ui)n[5].setComponents(l+a,d+h,p+v,M+T).normalize();else if(t===ya)n[5].setComponents(a,h,v,T).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+t);return this}intersectsObject(e){if(e.boundingSphere!==void 0)e.boundingSphere===null&&e.computeBoundingSphere(),gs.copy(e.boundingSphere).applyMatrix4(e.matrixWorld);else{const t=e.geometry;t.boundingSphere===null&&t.computeBoundingSphere(),gs.copy(t.boundingSphere).applyMatrix4(e.matrixWorld)}return this.intersectsSphere(gs)}intersectsSprite(e){return gs.center.set(0,0,0),gs.radius=.7071067811865476,gs.applyMatrix4(e.matrixWorld),this.intersectsSphere(gs)}intersectsSphere(e){const t=this.planes,n=e.center,s=-e.radius;for(let r=0;r<6;r++)if(t[r].distanceToPoint(n)<s)return!1;return!0}intersectsBox(e){const t=this.planes;for(let n=0;n<6;n++){const s=t[n];if(Qo.x=s.normal.x>0?e.max.x:e.min.x,Qo.y=s.normal.y>0?e.max.y:e.min.y,Qo.z=s.normal.z>0?e.max.z:e.min.z,s.distanceToPoint(Qo)<0)return!1}return!0}containsPoint(e){const t=this.planes;for(let n=0;n<6;n++)if(t[n].distanceToPoint(e)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}}function yp(){let i=null,e=!1,t=null,n=null;function s(r,o){t(r,o),n=i.requestAnimationFrame(s)}return{start:function(){e!==!0&&t!==null&&(n=i.requestAnimationFrame(s),e=!0)},stop:function(){i.cancelAnimationFrame(n),e=!1},setAnimationLoop:function(r){t=r},setContext:function(r){i=r}}}function PE(i){const e=new WeakMap;function t(a,l){const c=a.array,u=a.usage,h=c.byteLength,d=i.createBuffer();i.bindBuffer(l,d),i.bufferData(l,c,u),a.onUploadCallback();let m;if(c instanceof Float32Array)m=i.FLOAT;else if(c instanceof Uint16Array)a.isFloat16BufferAttribute?m=i.HALF_FLOAT:m=i.UNSIGNED_SHORT;else if(c instanceof Int16Array)m=i.SHORT;else if(c instanceof Uint32Array)m=i.UNSIGNED_INT;else if(c instanceof Int32Array)m=i.INT;else if(c instanceof Int8Array)m=i.BYTE;else if(c instanceof Uint8Array)m=i.UNSIGNED_BYTE;else if(c instanceof Uint8ClampedArray)m=i.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+c);return{buffer:d,type:m,bytesPerElement:c.BYTES_PER_ELEMENT,version:a.version,size:h}}function n(a,l,c){const u=l.array,h=l.updateRanges;if(i.bindBuffer(c,a),h.length===0)i.bufferSubData(c,0,u);else{h.sort((m,_)=>m.start-_.start);let d=0;for(let m=1;m<h.length;m++){const _=h[d],v=h[m];v.start<=_.start+_.count+1?_.count=Math.max(_.count,v.start+v.count-_.start):(++d,h[d]=v)}h.length=d+1;for(let m=0,_=h.length;m<_;m++){const v=h[m];i.bufferSubData(c,v.start*u.BYTES_PER_ELEMENT,u,v.start,v.count)}l.clearUpdateRanges()}l.onUploadCallback()}function s(a){return a.isInterleavedBufferAttribute&&(a=a.data),e.get(a)}function r(a){a.isInterleavedBufferAttribute&&(a=a.data);const l=e.get(a);l&&(i.deleteBuffer(l.buffer),e.delete(a))}function o(a,l){if(a.isInterleavedBufferAttribute&&(a=a.data),a.isGLBufferAttribute){const u=e.get(a);(!u||u.version<a.version)&&e.set(a,{buffer:a.buffer,type:a.type,bytesPerElement:a.elementSize,version:a.version});return}const c=e.get(a);if(c===void 0)e.set(a,t(a,l));else if(c.version<a.version){if(c.size!==a.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");n(c.buffer,a,l),c.version=a.version}}return{get:s,remove:r,update:o}}class yo extends yi{constructor(e=1,t=1,n=1,s=1){super(),this.type="PlaneGeometry",this.parameters={width:e,height:t,widthSegments:n,heightSegments:s};const r=e/2,o=t/2,a=Math.floor(n),l=Math.floor(s),c=a+1,u=l+1,h=e/a,d=t/l,m=[],_=[],v=[],p=[];for(let f=0;f<u;f++){const E=f*d-o;for(let T=0;T<c;T++){const M=T*h-r;_.push(M,-E,0),v.push(0,0,1),p.push(T/a),p.push(1-f/l)}}for(let f=0;f<l;f++)for(let E=0;E<a;E++){const T=E+c*f,M=E+c*(f+1),k=E+1+c*(f+1),L=E+1+c*f;m.push(T,M,L),m.push(M,k,L)}this.setIndex(m),this.setAttribute("position",new qn(_,3)),this.setAttribute("normal",new qn(v,3)),this.setAttribute("uv",new qn(p,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new yo(e.width,e.height,e.widthSegments,e.heightSegments)}}var LE=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,DE=`#ifdef USE_ALPHAHASH
	const float ALPHA_HASH_SCALE = 0.05;
	float hash2D( vec2 value ) {
		return fract( 1.0e4 * sin( 17.0 * value.x + 0.1 * value.y ) * ( 0.1 + abs( sin( 13.0 * value.y + value.x ) ) ) );
	}
	float hash3D( vec3 value ) {
		return hash2D( vec2( hash2D( value.xy ), value.z ) );
	}
	float getAlphaHashThreshold( vec3 position ) {
		float maxDeriv = max(
			length( dFdx( position.xyz ) ),
			length( dFdy( position.xyz ) )
		);
		float pixScale = 1.0 / ( ALPHA_HASH_SCALE * maxDeriv );
		vec2 pixScales = vec2(
			exp2( floor( log2( pixScale ) ) ),
			exp2( ceil( log2( pixScale ) ) )
		);
		vec2 alpha = vec2(
			hash3D( floor( pixScales.x * position.xyz ) ),
			hash3D( floor( pixScales.y * position.xyz ) )
		);
		float lerpFactor = fract( log2( pixScale ) );
		float x = ( 1.0 - lerpFactor ) * alpha.x + lerpFactor * alpha.y;
		float a = min( lerpFactor, 1.0 - lerpFactor );
		vec3 cases = vec3(
			x * x / ( 2.0 * a * ( 1.0 - a ) ),
			( x - 0.5 * a ) / ( 1.0 - a ),
			1.0 - ( ( 1.0 - x ) * ( 1.0 - x ) / ( 2.0 * a * ( 1.0 - a ) ) )
		);
		float threshold = ( x < ( 1.0 - a ) )
			? ( ( x < a ) ? cases.x : cases.y )
			: cases.z;
		return clamp( threshold , 1.0e-6, 1.0 );
	}
#endif`,NE=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,IE=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,UE=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,FE=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,OE=`#ifdef USE_AOMAP
	float ambientOcclusion = ( texture2D( aoMap, vAoMapUv ).r - 1.0 ) * aoMapIntensity + 1.0;
	reflectedLight.indirectDiffuse *= ambientOcclusion;
	#if defined( USE_CLEARCOAT ) 
		clearcoatSpecularIndirect *= ambientOcclusion;
	#endif
	#if defined( USE_SHEEN ) 
		sheenSpecularIndirect *= ambientOcclusion;
	#endif
	#if defined( USE_ENVMAP ) && defined( STANDARD )
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		reflectedLight.indirectSpecular *= computeSpecularOcclusion( dotNV, ambientOcclusion, material.roughness );
	#endif
#endif`,kE=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,BE=`#ifdef USE_BATCHING
	#if ! defined( GL_ANGLE_multi_draw )
	#define gl_DrawID _gl_DrawID
	uniform int _gl_DrawID;
	#endif
	uniform highp sampler2D batchingTexture;
	uniform highp usampler2D batchingIdTexture;
	mat4 getBatchingMatrix( const in float i ) {
		int size = textureSize( batchingTexture, 0 ).x;
		int j = int( i ) * 4;
		int x = j % size;
		int y = j / size;
		vec4 v1 = texelFetch( batchingTexture, ivec2( x, y ), 0 );
		vec4 v2 = texelFetch( batchingTexture, ivec2( x + 1, y ), 0 );
		vec4 v3 = texelFetch( batchingTexture, ivec2( x + 2, y ), 0 );
		vec4 v4 = texelFetch( batchingTexture, ivec2( x + 3, y ), 0 );
		return mat4( v1, v2, v3, v4 );
	}
	float getIndirectIndex( const in int i ) {
		int size = textureSize( batchingIdTexture, 0 ).x;
		int x = i % size;
		int y = i / size;
		return float( texelFetch( batchingIdTexture, ivec2( x, y ), 0 ).r );
	}
#endif
#ifdef USE_BATCHING_COLOR
	uniform sampler2D batchingColorTexture;
	vec3 getBatchingColor( const in float i ) {
		int size = textureSize( batchingColorTexture, 0 ).x;
		int j = int( i );
		int x = j % size;
		int y = j / size;
		return texelFetch( batchingColorTexture, ivec2( x, y ), 0 ).rgb;
	}
#endif`,zE=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,HE=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,VE=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,GE=`float G_BlinnPhong_Implicit( ) {
	return 0.25;
}
float D_BlinnPhong( const in float shininess, const in float dotNH ) {
	return RECIPROCAL_PI * ( shininess * 0.5 + 1.0 ) * pow( dotNH, shininess );
}
vec3 BRDF_BlinnPhong( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in vec3 specularColor, const in float shininess ) {
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNH = saturate( dot( normal, halfDir ) );
	float dotVH = saturate( dot( viewDir, halfDir ) );
	vec3 F = F_Schlick( specularColor, 1.0, dotVH );
	float G = G_BlinnPhong_Implicit( );
	float D = D_BlinnPhong( shininess, dotNH );
	return F * ( G * D );
} // validated`,WE=`#ifdef USE_IRIDESCENCE
	const mat3 XYZ_TO_REC709 = mat3(
		 3.2404542, -0.9692660,  0.0556434,
		-1.5371385,  1.8760108, -0.2040259,
		-0.4985314,  0.0415560,  1.0572252
	);
	vec3 Fresnel0ToIor( vec3 fresnel0 ) {
		vec3 sqrtF0 = sqrt( fresnel0 );
		return ( vec3( 1.0 ) + sqrtF0 ) / ( vec3( 1.0 ) - sqrtF0 );
	}
	vec3 IorToFresnel0( vec3 transmittedIor, float incidentIor ) {
		return pow2( ( transmittedIor - vec3( incidentIor ) ) / ( transmittedIor + vec3( incidentIor ) ) );
	}
	float IorToFresnel0( float transmittedIor, float incidentIor ) {
		return pow2( ( transmittedIor - incidentIor ) / ( transmittedIor + incidentIor ));
	}
	vec3 evalSensitivity( float OPD, vec3 shift ) {
		float phase = 2.0 * PI * OPD * 1.0e-9;
		vec3 val = vec3( 5.4856e-13, 4.4201e-13, 5.2481e-13 );
		vec3 pos = vec3( 1.6810e+06, 1.7953e+06, 2.2084e+06 );
		vec3 var = vec3( 4.3278e+09, 9.3046e+09, 6.6121e+09 );
		vec3 xyz = val * sqrt( 2.0 * PI * var ) * cos( pos * phase + shift ) * exp( - pow2( phase ) * var );
		xyz.x += 9.7470e-14 * sqrt( 2.0 * PI * 4.5282e+09 ) * cos( 2.2399e+06 * phase + shift[ 0 ] ) * exp( - 4.5282e+09 * pow2( phase ) );
		xyz /= 1.0685e-7;
		vec3 rgb = XYZ_TO_REC709 * xyz;
		return rgb;
	}
	vec3 evalIridescence( float outsideIOR, float eta2, float cosTheta1, float thinFilmThickness, vec3 baseF0 ) {
		vec3 I;
		float iridescenceIOR = mix( outsideIOR, eta2, smoothstep( 0.0, 0.03, thinFilmThickness ) );
		float sinTheta2Sq = pow2( outsideIOR / iridescenceIOR ) * ( 1.0 - pow2( cosTheta1 ) );
		float cosTheta2Sq = 1.0 - sinTheta2Sq;
		if ( cosTheta2Sq < 0.0 ) {
			return vec3( 1.0 );
		}
		float cosTheta2 = sqrt( cosTheta2Sq );
		float R0 = IorToFresnel0( iridescenceIOR, outsideIOR );
		float R12 = F_Schlick( R0, 1.0, cosTheta1 );
		float T121 = 1.0 - R12;
		float phi12 = 0.0;
		if ( iridescenceIOR < outsideIOR ) phi12 = PI;
		float phi21 = PI - phi12;
		vec3 baseIOR = Fresnel0ToIor( clamp( baseF0, 0.0, 0.9999 ) );		vec3 R1 = IorToFresnel0( baseIOR, iridescenceIOR );
		vec3 R23 = F_Schlick( R1, 1.0, cosTheta2 );
		vec3 phi23 = vec3( 0.0 );
		if ( baseIOR[ 0 ] < iridescenceIOR ) phi23[ 0 ] = PI;
		if ( baseIOR[ 1 ] < iridescenceIOR ) phi23[ 1 ] = PI;
		if ( baseIOR[ 2 ] < iridescenceIOR ) phi23[ 2 ] = PI;
		float OPD = 2.0 * iridescenceIOR * thinFilmThickness * cosTheta2;
		vec3 phi = vec3( phi21 ) + phi23;
		vec3 R123 = clamp( R12 * R23, 1e-5, 0.9999 );
		vec3 r123 = sqrt( R123 );
		vec3 Rs = pow2( T121 ) * R23 / ( vec3( 1.0 ) - R123 );
		vec3 C0 = R12 + Rs;
		I = C0;
		vec3 Cm = Rs - T121;
		for ( int m = 1; m <= 2; ++ m ) {
			Cm *= r123;
			vec3 Sm = 2.0 * evalSensitivity( float( m ) * OPD, float( m ) * phi );
			I += Cm * Sm;
		}
		return max( I, vec3( 0.0 ) );
	}
#endif`,$E=`#ifdef USE_BUMPMAP
	uniform sampler2D bumpMap;
	uniform float bumpScale;
	vec2 dHdxy_fwd() {
		vec2 dSTdx = dFdx( vBumpMapUv );
		vec2 dSTdy = dFdy( vBumpMapUv );
		float Hll = bumpScale * texture2D( bumpMap, vBumpMapUv ).x;
		float dBx = bumpScale * texture2D( bumpMap, vBumpMapUv + dSTdx ).x - Hll;
		float dBy = bumpScale * texture2D( bumpMap, vBumpMapUv + dSTdy ).x - Hll;
		return vec2( dBx, dBy );
	}
	vec3 perturbNormalArb( vec3 surf_pos, vec3 surf_norm, vec2 dHdxy, float faceDirection ) {
		vec3 vSigmaX = normalize( dFdx( surf_pos.xyz ) );
		vec3 vSigmaY = normalize( dFdy( surf_pos.xyz ) );
		vec3 vN = surf_norm;
		vec3 R1 = cross( vSigmaY, vN );
		vec3 R2 = cross( vN, vSigmaX );
		float fDet = dot( vSigmaX, R1 ) * faceDirection;
		vec3 vGrad = sign( fDet ) * ( dHdxy.x * R1 + dHdxy.y * R2 );
		return normalize( abs( fDet ) * surf_norm - vGrad );
	}
#endif`,XE=`#if NUM_CLIPPING_PLANES > 0
	vec4 plane;
	#ifdef ALPHA_TO_COVERAGE
		float distanceToPlane, distanceGradient;
		float clipOpacity = 1.0;
		#pragma unroll_loop_start
		for ( int i = 0; i < UNION_CLIPPING_PLANES; i ++ ) {
			plane = clippingPlanes[ i ];
			distanceToPlane = - dot( vClipPosition, plane.xyz ) + plane.w;
			distanceGradient = fwidth( distanceToPlane ) / 2.0;
			clipOpacity *= smoothstep( - distanceGradient, distanceGradient, distanceToPlane );
			if ( clipOpacity == 0.0 ) discard;
		}
		#pragma unroll_loop_end
		#if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES
			float unionClipOpacity = 1.0;
			#pragma unroll_loop_start
			for ( int i = UNION_CLIPPING_PLANES; i < NUM_CLIPPING_PLANES; i ++ ) {
				plane = clippingPlanes[ i ];
				distanceToPlane = - dot( vClipPosition, plane.xyz ) + plane.w;
				distanceGradient = fwidth( distanceToPlane ) / 2.0;
				unionClipOpacity *= 1.0 - smoothstep( - distanceGradient, distanceGradient, distanceToPlane );
			}
			#pragma unroll_loop_end
			clipOpacity *= 1.0 - unionClipOpacity;
		#endif
		diffuseColor.a *= clipOpacity;
		if ( diffuseColor.a == 0.0 ) discard;
	#else
		#pragma unroll_loop_start
		for ( int i = 0; i < UNION_CLIPPING_PLANES; i ++ ) {
			plane = clippingPlanes[ i ];
			if ( dot( vClipPosition, plane.xyz ) > plane.w ) discard;
		}
		#pragma unroll_loop_end
		#if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES
			bool clipped = true;
			#pragma unroll_loop_start
			for ( int i = UNION_CLIPPING_PLANES; i < NUM_CLIPPING_PLANES; i ++ ) {
				plane = clippingPlanes[ i ];
				clipped = ( dot( vClipPosition, plane.xyz ) > plane.w ) && clipped;
			}
			#pragma unroll_loop_end
			if ( clipped ) discard;
		#endif
	#endif
#endif`,qE=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,YE=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,jE=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,KE=`#if defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#elif defined( USE_COLOR )
	diffuseColor.rgb *= vColor;
#endif`,ZE=`#if defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#elif defined( USE_COLOR )
	varying vec3 vColor;
#endif`,JE=`#if defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#elif defined( USE_COLOR ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec3 vColor;
#endif`,QE=`#if defined( USE_COLOR_ALPHA )
	vColor = vec4( 1.0 );
#elif defined( USE_COLOR ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	vColor = vec3( 1.0 );
#endif
#ifdef USE_COLOR
	vColor *= color;
#endif
#ifdef USE_INSTANCING_COLOR
	vColor.xyz *= instanceColor.xyz;
#endif
#ifdef USE_BATCHING_COLOR
	vec3 batchingColor = getBatchingColor( getIndirectIndex( gl_DrawID ) );
	vColor.xyz *= batchingColor.xyz;
#endif`,ew=`#define PI 3.141592653589793
#define PI2 6.283185307179586
#define PI_HALF 1.5707963267948966
#define RECIPROCAL_PI 0.3183098861837907
#define RECIPROCAL_PI2 0.15915494309189535
#define EPSILON 1e-6
#ifndef saturate
#define saturate( a ) clamp( a, 0.0, 1.0 )
#endif
#define whiteComplement( a ) ( 1.0 - saturate( a ) )
float pow2( const in float x ) { return x*x; }
vec3 pow2( const in vec3 x ) { return x*x; }
float pow3( const in float x ) { return x*x*x; }
float pow4( const in float x ) { float x2 = x*x; return x2*x2; }
float max3( const in vec3 v ) { return max( max( v.x, v.y ), v.z ); }
float average( const in vec3 v ) { return dot( v, vec3( 0.3333333 ) ); }
highp float rand( const in vec2 uv ) {
	const highp float a = 12.9898, b = 78.233, c = 43758.5453;
	highp float dt = dot( uv.xy, vec2( a,b ) ), sn = mod( dt, PI );
	return fract( sin( sn ) * c );
}
#ifdef HIGH_PRECISION
	float precisionSafeLength( vec3 v ) { return length( v ); }
#else
	float precisionSafeLength( vec3 v ) {
		float maxComponent = max3( abs( v ) );
		return length( v / maxComponent ) * maxComponent;
	}
#endif
struct IncidentLight {
	vec3 color;
	vec3 direction;
	bool visible;
};
struct ReflectedLight {
	vec3 directDiffuse;
	vec3 directSpecular;
	vec3 indirectDiffuse;
	vec3 indirectSpecular;
};
#ifdef USE_ALPHAHASH
	varying vec3 vPosition;
#endif
vec3 transformDirection( in vec3 dir, in mat4 matrix ) {
	return normalize( ( matrix * vec4( dir, 0.0 ) ).xyz );
}
vec3 inverseTransformDirection( in vec3 dir, in mat4 matrix ) {
	return normalize( ( vec4( dir, 0.0 ) * matrix ).xyz );
}
mat3 transposeMat3( const in mat3 m ) {
	mat3 tmp;
	tmp[ 0 ] = vec3( m[ 0 ].x, m[ 1 ].x, m[ 2 ].x );
	tmp[ 1 ] = vec3( m[ 0 ].y, m[ 1 ].y, m[ 2 ].y );
	tmp[ 2 ] = vec3( m[ 0 ].z, m[ 1 ].z, m[ 2 ].z );
	return tmp;
}
bool isPerspectiveMatrix( mat4 m ) {
	return m[ 2 ][ 3 ] == - 1.0;
}
vec2 equirectUv( in vec3 dir ) {
	float u = atan( dir.z, dir.x ) * RECIPROCAL_PI2 + 0.5;
	float v = asin( clamp( dir.y, - 1.0, 1.0 ) ) * RECIPROCAL_PI + 0.5;
	return vec2( u, v );
}
vec3 BRDF_Lambert( const in vec3 diffuseColor ) {
	return RECIPROCAL_PI * diffuseColor;
}
vec3 F_Schlick( const in vec3 f0, const in float f90, const in float dotVH ) {
	float fresnel = exp2( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );
	return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );
}
float F_Schlick( const in float f0, const in float f90, const in float dotVH ) {
	float fresnel = exp2( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );
	return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );
} // validated`,tw=`#ifdef ENVMAP_TYPE_CUBE_UV
	#define cubeUV_minMipLevel 4.0
	#define cubeUV_minTileSize 16.0
	float getFace( vec3 direction ) {
		vec3 absDirection = abs( direction );
		float face = - 1.0;
		if ( absDirection.x > absDirection.z ) {
			if ( absDirection.x > absDirection.y )
				face = direction.x > 0.0 ? 0.0 : 3.0;
			else
				face = direction.y > 0.0 ? 1.0 : 4.0;
		} else {
			if ( absDirection.z > absDirection.y )
				face = direction.z > 0.0 ? 2.0 : 5.0;
			else
				face = direction.y > 0.0 ? 1.0 : 4.0;
		}
		return face;
	}
	vec2 getUV( vec3 direction, float face ) {
		vec2 uv;
		if ( face == 0.0 ) {
			uv = vec2( direction.z, direction.y ) / abs( direction.x );
		} else if ( face == 1.0 ) {
			uv = vec2( - direction.x, - direction.z ) / abs( direction.y );
		} else if ( face == 2.0 ) {
			uv = vec2( - direction.x, direction.y ) / abs( direction.z );
		} else if ( face == 3.0 ) {
			uv = vec2( - direction.z, direction.y ) / abs( direction.x );
		} else if ( face == 4.0 ) {
			uv = vec2( - direction.x, direction.z ) / abs( direction.y );
		} else {
			uv = vec2( direction.x, direction.y ) / abs( direction.z );
		}
		return 0.5 * ( uv + 1.0 );
	}
	vec3 bilinearCubeUV( sampler2D envMap, vec3 direction, float mipInt ) {
		float face = getFace( direction );
		float filterInt = max( cubeUV_minMipLevel - mipInt, 0.0 );
		mipInt = max( mipInt, cubeUV_minMipLevel );
		float faceSize = exp2( mipInt );
		highp vec2 uv = getUV( direction, face ) * ( faceSize - 2.0 ) + 1.0;
		if ( face > 2.0 ) {
			uv.y += faceSize;
			face -= 3.0;
		}
		uv.x += face * faceSize;
		uv.x += filterInt * 3.0 * cubeUV_minTileSize;
		uv.y += 4.0 * ( exp2( CUBEUV_MAX_MIP ) - faceSize );
		uv.x *= CUBEUV_TEXEL_WIDTH;
		uv.y *= CUBEUV_TEXEL_HEIGHT;
		#ifdef texture2DGradEXT
			return texture2DGradEXT( envMap, uv, vec2( 0.0 ), vec2( 0.0 ) ).rgb;
		#else
			return texture2D( envMap, uv ).rgb;
		#endif
	}
	#define cubeUV_r0 1.0
	#define cubeUV_m0 - 2.0
	#define cubeUV_r1 0.8
	#define cubeUV_m1 - 1.0
	#define cubeUV_r4 0.4
	#define cubeUV_m4 2.0
	#define cubeUV_r5 0.305
	#define cubeUV_m5 3.0
	#define cubeUV_r6 0.21
	#define cubeUV_m6 4.0
	float roughnessToMip( float roughness ) {
		float mip = 0.0;
		if ( roughness >= cubeUV_r1 ) {
			mip = ( cubeUV_r0 - roughness ) * ( cubeUV_m1 - cubeUV_m0 ) / ( cubeUV_r0 - cubeUV_r1 ) + cubeUV_m0;
		} else if ( roughness >= cubeUV_r4 ) {
			mip = ( cubeUV_r1 - roughness ) * ( cubeUV_m4 - cubeUV_m1 ) / ( cubeUV_r1 - cubeUV_r4 ) + cubeUV_m1;
		} else if ( roughness >= cubeUV_r5 ) {
			mip = ( cubeUV_r4 - roughness ) * ( cubeUV_m5 - cubeUV_m4 ) / ( cubeUV_r4 - cubeUV_r5 ) + cubeUV_m4;
		} else if ( roughness >= cubeUV_r6 ) {
			mip = ( cubeUV_r5 - roughness ) * ( cubeUV_m6 - cubeUV_m5 ) / ( cubeUV_r5 - cubeUV_r6 ) + cubeUV_m5;
		} else {
			mip = - 2.0 * log2( 1.16 * roughness );		}
		return mip;
	}
	vec4 textureCubeUV( sampler2D envMap, vec3 sampleDir, float roughness ) {
		float mip = clamp( roughnessToMip( roughness ), cubeUV_m0, CUBEUV_MAX_MIP );
		float mipF = fract( mip );
		float mipInt = floor( mip );
		vec3 color0 = bilinearCubeUV( envMap, sampleDir, mipInt );
		if ( mipF == 0.0 ) {
			return vec4( color0, 1.0 );
		} else {
			vec3 color1 = bilinearCubeUV( envMap, sampleDir, mipInt + 1.0 );
			return vec4( mix( color0, color1, mipF ), 1.0 );
		}
	}
#endif`,nw=`vec3 transformedNormal = objectNormal;
#ifdef USE_TANGENT
	vec3 transformedTangent = objectTangent;
#endif
#ifdef USE_BATCHING
	mat3 bm = mat3( batchingMatrix );
	transformedNormal /= vec3( dot( bm[ 0 ], bm[ 0 ] ), dot( bm[ 1 ], bm[ 1 ] ), dot( bm[ 2 ], bm[ 2 ] ) );
	transformedNormal = bm * transformedNormal;
	#ifdef USE_TANGENT
		transformedTangent = bm * transformedTangent;
	#endif
#endif
#ifdef USE_INSTANCING
	mat3 im = mat3( instanceMatrix );
	transformedNormal /= vec3( dot( im[ 0 ], im[ 0 ] ), dot( im[ 1 ], im[ 1 ] ), dot( im[ 2 ], im[ 2 ] ) );
	transformedNormal = im * transformedNormal;
	#ifdef USE_TANGENT
		transformedTangent = im * transformedTangent;
	#endif
#endif
transformedNormal = normalMatrix * transformedNormal;
#ifdef FLIP_SIDED
	transformedNormal = - transformedNormal;
#endif
#ifdef USE_TANGENT
	transformedTangent = ( modelViewMatrix * vec4( transformedTangent, 0.0 ) ).xyz;
	#ifdef FLIP_SIDED
		transformedTangent = - transformedTangent;
	#endif
#endif`,iw=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,sw=`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,rw=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,ow=`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,aw="gl_FragColor = linearToOutputTexel( gl_FragColor );",lw=`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,cw=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vec3 cameraToFrag;
		if ( isOrthographic ) {
			cameraToFrag = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToFrag = normalize( vWorldPosition - cameraPosition );
		}
		vec3 worldNormal = inverseTransformDirection( normal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vec3 reflectVec = reflect( cameraToFrag, worldNormal );
		#else
			vec3 reflectVec = refract( cameraToFrag, worldNormal, refractionRatio );
		#endif
	#else
		vec3 reflectVec = vReflect;
	#endif
	#ifdef ENVMAP_TYPE_CUBE
		vec4 envColor = textureCube( envMap, envMapRotation * vec3( flipEnvMap * reflectVec.x, reflectVec.yz ) );
	#else
		vec4 envColor = vec4( 0.0 );
	#endif
	#ifdef ENVMAP_BLENDING_MULTIPLY
		outgoingLight = mix( outgoingLight, outgoingLight * envColor.xyz, specularStrength * reflectivity );
	#elif defined( ENVMAP_BLENDING_MIX )
		outgoingLight = mix( outgoingLight, envColor.xyz, specularStrength * reflectivity );
	#elif defined( ENVMAP_BLENDING_ADD )
		outgoingLight += envColor.xyz * specularStrength * reflectivity;
	#endif
#endif`,uw=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform float flipEnvMap;
	uniform mat3 envMapRotation;
	#ifdef ENVMAP_TYPE_CUBE
		uniform samplerCube envMap;
	#else
		uniform sampler2D envMap;
	#endif
	
#endif`,hw=`#ifdef USE_ENVMAP
	uniform float reflectivity;
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		varying vec3 vWorldPosition;
		uniform float refractionRatio;
	#else
		varying vec3 vReflect;
	#endif
#endif`,dw=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,fw=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vWorldPosition = worldPosition.xyz;
	#else
		vec3 cameraToVertex;
		if ( isOrthographic ) {
			cameraToVertex = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToVertex = normalize( worldPosition.xyz - cameraPosition );
		}
		vec3 worldNormal = inverseTransformDirection( transformedNormal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vReflect = reflect( cameraToVertex, worldNormal );
		#else
			vReflect = refract( cameraToVertex, worldNormal, refractionRatio );
		#endif
	#endif
#endif`,pw=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,mw=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,gw=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,_w=`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,vw=`#ifdef USE_GRADIENTMAP
	uniform sampler2D gradientMap;
#endif
vec3 getGradientIrradiance( vec3 normal, vec3 lightDirection ) {
	float dotNL = dot( normal, lightDirection );
	vec2 coord = vec2( dotNL * 0.5 + 0.5, 0.0 );
	#ifdef USE_GRADIENTMAP
		return vec3( texture2D( gradientMap, coord ).r );
	#else
		vec2 fw = fwidth( coord ) * 0.5;
		return mix( vec3( 0.7 ), vec3( 1.0 ), smoothstep( 0.7 - fw.x, 0.7 + fw.x, coord.x ) );
	#endif
}`,xw=`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,Mw=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,Sw=`varying vec3 vViewPosition;
struct LambertMaterial {
	vec3 diffuseColor;
	float specularStrength;
};
void RE_Direct_Lambert( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Lambert( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_Lambert
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,yw=`uniform bool receiveShadow;
uniform vec3 ambientLightColor;
#if defined( USE_LIGHT_PROBES )
	uniform vec3 lightProbe[ 9 ];
#endif
vec3 shGetIrradianceAt( in vec3 normal, in vec3 shCoefficients[ 9 ] ) {
	float x = normal.x, y = normal.y, z = normal.z;
	vec3 result = shCoefficients[ 0 ] * 0.886227;
	result += shCoefficients[ 1 ] * 2.0 * 0.511664 * y;
	result += shCoefficients[ 2 ] * 2.0 * 0.511664 * z;
	result += shCoefficients[ 3 ] * 2.0 * 0.511664 * x;
	result += shCoefficients[ 4 ] * 2.0 * 0.429043 * x * y;
	result += shCoefficients[ 5 ] * 2.0 * 0.429043 * y * z;
	result += shCoefficients[ 6 ] * ( 0.743125 * z * z - 0.247708 );
	result += shCoefficients[ 7 ] * 2.0 * 0.429043 * x * z;
	result += shCoefficients[ 8 ] * 0.429043 * ( x * x - y * y );
	return result;
}
vec3 getLightProbeIrradiance( const in vec3 lightProbe[ 9 ], const in vec3 normal ) {
	vec3 worldNormal = inverseTransformDirection( normal, viewMatrix );
	vec3 irradiance = shGetIrradianceAt( worldNormal, lightProbe );
	return irradiance;
}
vec3 getAmbientLightIrradiance( const in vec3 ambientLightColor ) {
	vec3 irradiance = ambientLightColor;
	return irradiance;
}
float getDistanceAttenuation( const in float lightDistance, const in float cutoffDistance, const in float decayExponent ) {
	float distanceFalloff = 1.0 / max( pow( lightDistance, decayExponent ), 0.01 );
	if ( cutoffDistance > 0.0 ) {
		distanceFalloff *= pow2( saturate( 1.0 - pow4( lightDistance / cutoffDistance ) ) );
	}
	return distanceFalloff;
}
float getSpotAttenuation( const in float coneCosine, const in float penumbraCosine, const in float angleCosine ) {
	return smoothstep( coneCosine, penumbraCosine, angleCosine );
}
#if NUM_DIR_LIGHTS > 0
	struct DirectionalLight {
		vec3 direction;
		vec3 color;
	};
	uniform DirectionalLight directionalLights[ NUM_DIR_LIGHTS ];
	void getDirectionalLightInfo( const in DirectionalLight directionalLight, out IncidentLight light ) {
		light.color = directionalLight.color;
		light.direction = directionalLight.direction;
		light.visible = true;
	}
#endif
#if NUM_POINT_LIGHTS > 0
	struct PointLight {
		vec3 position;
		vec3 color;
		float distance;
		float decay;
	};
	uniform PointLight pointLights[ NUM_POINT_LIGHTS ];
	void getPointLightInfo( const in PointLight pointLight, const in vec3 geometryPosition, out IncidentLight light ) {
		vec3 lVector = pointLight.position - geometryPosition;
		light.direction = normalize( lVector );
		float lightDistance = length( lVector );
		light.color = pointLight.color;
		light.color *= getDistanceAttenuation( lightDistance, pointLight.distance, pointLight.decay );
		light.visible = ( light.color != vec3( 0.0 ) );
	}
#endif
#if NUM_SPOT_LIGHTS > 0
	struct SpotLight {
		vec3 position;
		vec3 direction;
		vec3 color;
		float distance;
		float decay;
		float coneCos;
		float penumbraCos;
	};
	uniform SpotLight spotLights[ NUM_SPOT_LIGHTS ];
	void getSpotLightInfo( const in SpotLight spotLight, const in vec3 geometryPosition, out IncidentLight light ) {
		vec3 lVector = spotLight.position - geometryPosition;
		light.direction = normalize( lVector );
		float angleCos = dot( light.direction, spotLight.direction );
		float spotAttenuation = getSpotAttenuation( spotLight.coneCos, spotLight.penumbraCos, angleCos );
		if ( spotAttenuation > 0.0 ) {
			float lightDistance = length( lVector );
			light.color = spotLight.color * spotAttenuation;
			light.color *= getDistanceAttenuation( lightDistance, spotLight.distance, spotLight.decay );
			light.visible = ( light.color != vec3( 0.0 ) );
		} else {
			light.color = vec3( 0.0 );
			light.visible = false;
		}
	}
#endif
#if NUM_RECT_AREA_LIGHTS > 0
	struct RectAreaLight {
		vec3 color;
		vec3 position;
		vec3 halfWidth;
		vec3 halfHeight;
	};
	uniform sampler2D ltc_1;	uniform sampler2D ltc_2;
	uniform RectAreaLight rectAreaLights[ NUM_RECT_AREA_LIGHTS ];
#endif
#if NUM_HEMI_LIGHTS > 0
	struct HemisphereLight {
		vec3 direction;
		vec3 skyColor;
		vec3 groundColor;
	};
	uniform HemisphereLight hemisphereLights[ NUM_HEMI_LIGHTS ];
	vec3 getHemisphereLightIrradiance( const in HemisphereLight hemiLight, const in vec3 normal ) {
		float dotNL = dot( normal, hemiLight.direction );
		float hemiDiffuseWeight = 0.5 * dotNL + 0.5;
		vec3 irradiance = mix( hemiLight.groundColor, hemiLight.skyColor, hemiDiffuseWeight );
		return irradiance;
	}
#endif`,bw=`#ifdef USE_ENVMAP
	vec3 getIBLIrradiance( const in vec3 normal ) {
		#ifdef ENVMAP_TYPE_CUBE_UV
			vec3 worldNormal = inverseTransformDirection( normal, viewMatrix );
			vec4 envMapColor = textureCubeUV( envMap, envMapRotation * worldNormal, 1.0 );
			return PI * envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	vec3 getIBLRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness ) {
		#ifdef ENVMAP_TYPE_CUBE_UV
			vec3 reflectVec = reflect( - viewDir, normal );
			reflectVec = normalize( mix( reflectVec, normal, roughness * roughness) );
			reflectVec = inverseTransformDirection( reflectVec, viewMatrix );
			vec4 envMapColor = textureCubeUV( envMap, envMapRotation * reflectVec, roughness );
			return envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	#ifdef USE_ANISOTROPY
		vec3 getIBLAnisotropyRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness, const in vec3 bitangent, const in float anisotropy ) {
			#ifdef ENVMAP_TYPE_CUBE_UV
				vec3 bentNormal = cross( bitangent, viewDir );
				bentNormal = normalize( cross( bentNormal, bitangent ) );
				bentNormal = normalize( mix( bentNormal, normal, pow2( pow2( 1.0 - anisotropy * ( 1.0 - roughness ) ) ) ) );
				return getIBLRadiance( viewDir, bentNormal, roughness );
			#else
				return vec3( 0.0 );
			#endif
		}
	#endif
#endif`,Ew=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,ww=`varying vec3 vViewPosition;
struct ToonMaterial {
	vec3 diffuseColor;
};
void RE_Direct_Toon( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in ToonMaterial material, inout ReflectedLight reflectedLight ) {
	vec3 irradiance = getGradientIrradiance( geometryNormal, directLight.direction ) * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Toon( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in ToonMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_Toon
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,Tw=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,Aw=`varying vec3 vViewPosition;
struct BlinnPhongMaterial {
	vec3 diffuseColor;
	vec3 specularColor;
	float specularShininess;
	float specularStrength;
};
void RE_Direct_BlinnPhong( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in BlinnPhongMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
	reflectedLight.directSpecular += irradiance * BRDF_BlinnPhong( directLight.direction, geometryViewDir, geometryNormal, material.specularColor, material.specularShininess ) * material.specularStrength;
}
void RE_IndirectDiffuse_BlinnPhong( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in BlinnPhongMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_BlinnPhong
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,Rw=`PhysicalMaterial material;
material.diffuseColor = diffuseColor.rgb * ( 1.0 - metalnessFactor );
vec3 dxy = max( abs( dFdx( nonPerturbedNormal ) ), abs( dFdy( nonPerturbedNormal ) ) );
float geometryRoughness = max( max( dxy.x, dxy.y ), dxy.z );
material.roughness = max( roughnessFactor, 0.0525 );material.roughness += geometryRoughness;
material.roughness = min( material.roughness, 1.0 );
#ifdef IOR
	material.ior = ior;
	#ifdef USE_SPECULAR
		float specularIntensityFactor = specularIntensity;
		vec3 specularColorFactor = specularColor;
		#ifdef USE_SPECULAR_COLORMAP
			specularColorFactor *= texture2D( specularColorMap, vSpecularColorMapUv ).rgb;
		#endif
		#ifdef USE_SPECULAR_INTENSITYMAP
			specularIntensityFactor *= texture2D( specularIntensityMap, vSpecularIntensityMapUv ).a;
		#endif
		material.specularF90 = mix( specularIntensityFactor, 1.0, metalnessFactor );
	#else
		float specularIntensityFactor = 1.0;
		vec3 specularColorFactor = vec3( 1.0 );
		material.specularF90 = 1.0;
	#endif
	material.specularColor = mix( min( pow2( ( material.ior - 1.0 ) / ( material.ior + 1.0 ) ) * specularColorFactor, vec3( 1.0 ) ) * specularIntensityFactor, diffuseColor.rgb, metalnessFactor );
#else
	material.specularColor = mix( vec3( 0.04 ), diffuseColor.rgb, metalnessFactor );
	material.specularF90 = 1.0;
#endif
#ifdef USE_CLEARCOAT
	material.clearcoat = clearcoat;
	material.clearcoatRoughness = clearcoatRoughness;
	material.clearcoatF0 = vec3( 0.04 );
	material.clearcoatF90 = 1.0;
	#ifdef USE_CLEARCOATMAP
		material.clearcoat *= texture2D( clearcoatMap, vClearcoatMapUv ).x;
	#endif
	#ifdef USE_CLEARCOAT_ROUGHNESSMAP
		material.clearcoatRoughness *= texture2D( clearcoatRoughnessMap, vClearcoatRoughnessMapUv ).y;
	#endif
	material.clearcoat = saturate( material.clearcoat );	material.clearcoatRoughness = max( material.clearcoatRoughness, 0.0525 );
	material.clearcoatRoughness += geometryRoughness;
	material.clearcoatRoughness = min( material.clearcoatRoughness, 1.0 );
#endif
#ifdef USE_DISPERSION
	material.dispersion = dispersion;
#endif
#ifdef USE_IRIDESCENCE
	material.iridescence = iridescence;
	material.iridescenceIOR = iridescenceIOR;
	#ifdef USE_IRIDESCENCEMAP
		material.iridescence *= texture2D( iridescenceMap, vIridescenceMapUv ).r;
	#endif
	#ifdef USE_IRIDESCENCE_THICKNESSMAP
		material.iridescenceThickness = (iridescenceThicknessMaximum - iridescenceThicknessMinimum) * texture2D( iridescenceThicknessMap, vIridescenceThicknessMapUv ).g + iridescenceThicknessMinimum;
	#else
		material.iridescenceThickness = iridescenceThicknessMaximum;
	#endif
#endif
#ifdef USE_SHEEN
	material.sheenColor = sheenColor;
	#ifdef USE_SHEEN_COLORMAP
		material.sheenColor *= texture2D( sheenColorMap, vSheenColorMapUv ).rgb;
	#endif
	material.sheenRoughness = clamp( sheenRoughness, 0.07, 1.0 );
	#ifdef USE_SHEEN_ROUGHNESSMAP
		material.sheenRoughness *= texture2D( sheenRoughnessMap, vSheenRoughnessMapUv ).a;
	#endif
#endif
#ifdef USE_ANISOTROPY
	#ifdef USE_ANISOTROPYMAP
		mat2 anisotropyMat = mat2( anisotropyVector.x, anisotropyVector.y, - anisotropyVector.y, anisotropyVector.x );
		vec3 anisotropyPolar = texture2D( anisotropyMap, vAnisotropyMapUv ).rgb;
		vec2 anisotropyV = anisotropyMat * normalize( 2.0 * anisotropyPolar.rg - vec2( 1.0 ) ) * anisotropyPolar.b;
	#else
		vec2 anisotropyV = anisotropyVector;
	#endif
	material.anisotropy = length( anisotropyV );
	if( material.anisotropy == 0.0 ) {
		anisotropyV = vec2( 1.0, 0.0 );
	} else {
		anisotropyV /= material.anisotropy;
		material.anisotropy = saturate( material.anisotropy );
	}
	material.alphaT = mix( pow2( material.roughness ), 1.0, pow2( material.anisotropy ) );
	material.anisotropyT = tbn[ 0 ] * anisotropyV.x + tbn[ 1 ] * anisotropyV.y;
	material.anisotropyB = tbn[ 1 ] * anisotropyV.x - tbn[ 0 ] * anisotropyV.y;
#endif`,Cw=`struct PhysicalMaterial {
	vec3 diffuseColor;
	float roughness;
	vec3 specularColor;
	float specularF90;
	float dispersion;
	#ifdef USE_CLEARCOAT
		float clearcoat;
		float clearcoatRoughness;
		vec3 clearcoatF0;
		float clearcoatF90;
	#endif
	#ifdef USE_IRIDESCENCE
		float iridescence;
		float iridescenceIOR;
		float iridescenceThickness;
		vec3 iridescenceFresnel;
		vec3 iridescenceF0;
	#endif
	#ifdef USE_SHEEN
		vec3 sheenColor;
		float sheenRoughness;
	#endif
	#ifdef IOR
		float ior;
	#endif
	#ifdef USE_TRANSMISSION
		float transmission;
		float transmissionAlpha;
		float thickness;
		float attenuationDistance;
		vec3 attenuationColor;
	#endif
	#ifdef USE_ANISOTROPY
		float anisotropy;
		float alphaT;
		vec3 anisotropyT;
		vec3 anisotropyB;
	#endif
};
vec3 clearcoatSpecularDirect = vec3( 0.0 );
vec3 clearcoatSpecularIndirect = vec3( 0.0 );
vec3 sheenSpecularDirect = vec3( 0.0 );
vec3 sheenSpecularIndirect = vec3(0.0 );
vec3 Schlick_to_F0( const in vec3 f, const in float f90, const in float dotVH ) {
    float x = clamp( 1.0 - dotVH, 0.0, 1.0 );
    float x2 = x * x;
    float x5 = clamp( x * x2 * x2, 0.0, 0.9999 );
    return ( f - vec3( f90 ) * x5 ) / ( 1.0 - x5 );
}
float V_GGX_SmithCorrelated( const in float alpha, const in float dotNL, const in float dotNV ) {
	float a2 = pow2( alpha );
	float gv = dotNL * sqrt( a2 + ( 1.0 - a2 ) * pow2( dotNV ) );
	float gl = dotNV * sqrt( a2 + ( 1.0 - a2 ) * pow2( dotNL ) );
	return 0.5 / max( gv + gl, EPSILON );
}
float D_GGX( const in float alpha, const in float dotNH ) {
	float a2 = pow2( alpha );
	float denom = pow2( dotNH ) * ( a2 - 1.0 ) + 1.0;
	return RECIPROCAL_PI * a2 / pow2( denom );
}
#ifdef USE_ANISOTROPY
	float V_GGX_SmithCorrelated_Anisotropic( const in float alphaT, const in float alphaB, const in float dotTV, const in float dotBV, const in float dotTL, const in float dotBL, const in float dotNV, const in float dotNL ) {
		float gv = dotNL * length( vec3( alphaT * dotTV, alphaB * dotBV, dotNV ) );
		float gl = dotNV * length( vec3( alphaT * dotTL, alphaB * dotBL, dotNL ) );
		float v = 0.5 / ( gv + gl );
		return saturate(v);
	}
	float D_GGX_Anisotropic( const in float alphaT, const in float alphaB, const in float dotNH, const in float dotTH, const in float dotBH ) {
		float a2 = alphaT * alphaB;
		highp vec3 v = vec3( alphaB * dotTH, alphaT * dotBH, a2 * dotNH );
		highp float v2 = dot( v, v );
		float w2 = a2 / v2;
		return RECIPROCAL_PI * a2 * pow2 ( w2 );
	}
#endif
#ifdef USE_CLEARCOAT
	vec3 BRDF_GGX_Clearcoat( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in PhysicalMaterial material) {
		vec3 f0 = material.clearcoatF0;
		float f90 = material.clearcoatF90;
		float roughness = material.clearcoatRoughness;
		float alpha = pow2( roughness );
		vec3 halfDir = normalize( lightDir + viewDir );
		float dotNL = saturate( dot( normal, lightDir ) );
		float dotNV = saturate( dot( normal, viewDir ) );
		float dotNH = saturate( dot( normal, halfDir ) );
		float dotVH = saturate( dot( viewDir, halfDir ) );
		vec3 F = F_Schlick( f0, f90, dotVH );
		float V = V_GGX_SmithCorrelated( alpha, dotNL, dotNV );
		float D = D_GGX( alpha, dotNH );
		return F * ( V * D );
	}
#endif
vec3 BRDF_GGX( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in PhysicalMaterial material ) {
	vec3 f0 = material.specularColor;
	float f90 = material.specularF90;
	float roughness = material.roughness;
	float alpha = pow2( roughness );
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNL = saturate( dot( normal, lightDir ) );
	float dotNV = saturate( dot( normal, viewDir ) );
	float dotNH = saturate( dot( normal, halfDir ) );
	float dotVH = saturate( dot( viewDir, halfDir ) );
	vec3 F = F_Schlick( f0, f90, dotVH );
	#ifdef USE_IRIDESCENCE
		F = mix( F, material.iridescenceFresnel, material.iridescence );
	#endif
	#ifdef USE_ANISOTROPY
		float dotTL = dot( material.anisotropyT, lightDir );
		float dotTV = dot( material.anisotropyT, viewDir );
		float dotTH = dot( material.anisotropyT, halfDir );
		float dotBL = dot( material.anisotropyB, lightDir );
		float dotBV = dot( material.anisotropyB, viewDir );
		float dotBH = dot( material.anisotropyB, halfDir );
		float V = V_GGX_SmithCorrelated_Anisotropic( material.alphaT, alpha, dotTV, dotBV, dotTL, dotBL, dotNV, dotNL );
		float D = D_GGX_Anisotropic( material.alphaT, alpha, dotNH, dotTH, dotBH );
	#else
		float V = V_GGX_SmithCorrelated( alpha, dotNL, dotNV );
		float D = D_GGX( alpha, dotNH );
	#endif
	return F * ( V * D );
}
vec2 LTC_Uv( const in vec3 N, const in vec3 V, const in float roughness ) {
	const float LUT_SIZE = 64.0;
	const float LUT_SCALE = ( LUT_SIZE - 1.0 ) / LUT_SIZE;
	const float LUT_BIAS = 0.5 / LUT_SIZE;
	float dotNV = saturate( dot( N, V ) );
	vec2 uv = vec2( roughness, sqrt( 1.0 - dotNV ) );
	uv = uv * LUT_SCALE + LUT_BIAS;
	return uv;
}
float LTC_ClippedSphereFormFactor( const in vec3 f ) {
	float l = length( f );
	return max( ( l * l + f.z ) / ( l + 1.0 ), 0.0 );
}
vec3 LTC_EdgeVectorFormFactor( const in vec3 v1, const in vec3 v2 ) {
	float x = dot( v1, v2 );
	float y = abs( x );
	float a = 0.8543985 + ( 0.4965155 + 0.0145206 * y ) * y;
	float b = 3.4175940 + ( 4.1616724 + y ) * y;
	float v = a / b;
	float theta_sintheta = ( x > 0.0 ) ? v : 0.5 * inversesqrt( max( 1.0 - x * x, 1e-7 ) ) - v;
	return cross( v1, v2 ) * theta_sintheta;
}
vec3 LTC_Evaluate( const in vec3 N, const in vec3 V, const in vec3 P, const in mat3 mInv, const in vec3 rectCoords[ 4 ] ) {
	vec3 v1 = rectCoords[ 1 ] - rectCoords[ 0 ];
	vec3 v2 = rectCoords[ 3 ] - rectCoords[ 0 ];
	vec3 lightNormal = cross( v1, v2 );
	if( dot( lightNormal, P - rectCoords[ 0 ] ) < 0.0 ) return vec3( 0.0 );
	vec3 T1, T2;
	T1 = normalize( V - N * dot( V, N ) );
	T2 = - cross( N, T1 );
	mat3 mat = mInv * transposeMat3( mat3( T1, T2, N ) );
	vec3 coords[ 4 ];
	coords[ 0 ] = mat * ( rectCoords[ 0 ] - P );
	coords[ 1 ] = mat * ( rectCoords[ 1 ] - P );
	coords[ 2 ] = mat * ( rectCoords[ 2 ] - P );
	coords[ 3 ] = mat * ( rectCoords[ 3 ] - P );
	coords[ 0 ] = normalize( coords[ 0 ] );
	coords[ 1 ] = normalize( coords[ 1 ] );
	coords[ 2 ] = normalize( coords[ 2 ] );
	coords[ 3 ] = normalize( coords[ 3 ] );
	vec3 vectorFormFactor = vec3( 0.0 );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 0 ], coords[ 1 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 1 ], coords[ 2 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 2 ], coords[ 3 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 3 ], coords[ 0 ] );
	float result = LTC_ClippedSphereFormFactor( vectorFormFactor );
	return vec3( result );
}
#if defined( USE_SHEEN )
float D_Charlie( float roughness, float dotNH ) {
	float alpha = pow2( roughness );
	float invAlpha = 1.0 / alpha;
	float cos2h = dotNH * dotNH;
	float sin2h = max( 1.0 - cos2h, 0.0078125 );
	return ( 2.0 + invAlpha ) * pow( sin2h, invAlpha * 0.5 ) / ( 2.0 * PI );
}
float V_Neubelt( float dotNV, float dotNL ) {
	return saturate( 1.0 / ( 4.0 * ( dotNL + dotNV - dotNL * dotNV ) ) );
}
vec3 BRDF_Sheen( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, vec3 sheenColor, const in float sheenRoughness ) {
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNL = saturate( dot( normal, lightDir ) );
	float dotNV = saturate( dot( normal, viewDir ) );
	float dotNH = saturate( dot( normal, halfDir ) );
	float D = D_Charlie( sheenRoughness, dotNH );
	float V = V_Neubelt( dotNV, dotNL );
	return sheenColor * ( D * V );
}
#endif
float IBLSheenBRDF( const in vec3 normal, const in vec3 viewDir, const in float roughness ) {
	float dotNV = saturate( dot( normal, viewDir ) );
	float r2 = roughness * roughness;
	float a = roughness < 0.25 ? -339.2 * r2 + 161.4 * roughness - 25.9 : -8.48 * r2 + 14.3 * roughness - 9.95;
	float b = roughness < 0.25 ? 44.0 * r2 - 23.7 * roughness + 3.26 : 1.97 * r2 - 3.27 * roughness + 0.72;
	float DG = exp( a * dotNV + b ) + ( roughness < 0.25 ? 0.0 : 0.1 * ( roughness - 0.25 ) );
	return saturate( DG * RECIPROCAL_PI );
}
vec2 DFGApprox( const in vec3 normal, const in vec3 viewDir, const in float roughness ) {
	float dotNV = saturate( dot( normal, viewDir ) );
	const vec4 c0 = vec4( - 1, - 0.0275, - 0.572, 0.022 );
	const vec4 c1 = vec4( 1, 0.0425, 1.04, - 0.04 );
	vec4 r = roughness * c0 + c1;
	float a004 = min( r.x * r.x, exp2( - 9.28 * dotNV ) ) * r.x + r.y;
	vec2 fab = vec2( - 1.04, 1.04 ) * a004 + r.zw;
	return fab;
}
vec3 EnvironmentBRDF( const in vec3 normal, const in vec3 viewDir, const in vec3 specularColor, const in float specularF90, const in float roughness ) {
	vec2 fab = DFGApprox( normal, viewDir, roughness );
	return specularColor * fab.x + specularF90 * fab.y;
}
#ifdef USE_IRIDESCENCE
void computeMultiscatteringIridescence( const in vec3 normal, const in vec3 viewDir, const in vec3 specularColor, const in float specularF90, const in float iridescence, const in vec3 iridescenceF0, const in float roughness, inout vec3 singleScatter, inout vec3 multiScatter ) {
#else
void computeMultiscattering( const in vec3 normal, const in vec3 viewDir, const in vec3 specularColor, const in float specularF90, const in float roughness, inout vec3 singleScatter, inout vec3 multiScatter ) {
#endif
	vec2 fab = DFGApprox( normal, viewDir, roughness );
	#ifdef USE_IRIDESCENCE
		vec3 Fr = mix( specularColor, iridescenceF0, iridescence );
	#else
		vec3 Fr = specularColor;
	#endif
	vec3 FssEss = Fr * fab.x + specularF90 * fab.y;
	float Ess = fab.x + fab.y;
	float Ems = 1.0 - Ess;
	vec3 Favg = Fr + ( 1.0 - Fr ) * 0.047619;	vec3 Fms = FssEss * Favg / ( 1.0 - Ems * Favg );
	singleScatter += FssEss;
	multiScatter += Fms * Ems;
}
#if NUM_RECT_AREA_LIGHTS > 0
	void RE_Direct_RectArea_Physical( const in RectAreaLight rectAreaLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
		vec3 normal = geometryNormal;
		vec3 viewDir = geometryViewDir;
		vec3 position = geometryPosition;
		vec3 lightPos = rectAreaLight.position;
		vec3 halfWidth = rectAreaLight.halfWidth;
		vec3 halfHeight = rectAreaLight.halfHeight;
		vec3 lightColor = rectAreaLight.color;
		float roughness = material.roughness;
		vec3 rectCoords[ 4 ];
		rectCoords[ 0 ] = lightPos + halfWidth - halfHeight;		rectCoords[ 1 ] = lightPos - halfWidth - halfHeight;
		rectCoords[ 2 ] = lightPos - halfWidth + halfHeight;
		rectCoords[ 3 ] = lightPos + halfWidth + halfHeight;
		vec2 uv = LTC_Uv( normal, viewDir, roughness );
		vec4 t1 = texture2D( ltc_1, uv );
		vec4 t2 = texture2D( ltc_2, uv );
		mat3 mInv = mat3(
			vec3( t1.x, 0, t1.y ),
			vec3(    0, 1,    0 ),
			vec3( t1.z, 0, t1.w )
		);
		vec3 fresnel = ( material.specularColor * t2.x + ( vec3( 1.0 ) - material.specularColor ) * t2.y );
		reflectedLight.directSpecular += lightColor * fresnel * LTC_Evaluate( normal, viewDir, position, mInv, rectCoords );
		reflectedLight.directDiffuse += lightColor * material.diffuseColor * LTC_Evaluate( normal, viewDir, position, mat3( 1.0 ), rectCoords );
	}
#endif
void RE_Direct_Physical( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	#ifdef USE_CLEARCOAT
		float dotNLcc = saturate( dot( geometryClearcoatNormal, directLight.direction ) );
		vec3 ccIrradiance = dotNLcc * directLight.color;
		clearcoatSpecularDirect += ccIrradiance * BRDF_GGX_Clearcoat( directLight.direction, geometryViewDir, geometryClearcoatNormal, material );
	#endif
	#ifdef USE_SHEEN
		sheenSpecularDirect += irradiance * BRDF_Sheen( directLight.direction, geometryViewDir, geometryNormal, material.sheenColor, material.sheenRoughness );
	#endif
	reflectedLight.directSpecular += irradiance * BRDF_GGX( directLight.direction, geometryViewDir, geometryNormal, material );
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Physical( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectSpecular_Physical( const in vec3 radiance, const in vec3 irradiance, const in vec3 clearcoatRadiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight) {
	#ifdef USE_CLEARCOAT
		clearcoatSpecularIndirect += clearcoatRadiance * EnvironmentBRDF( geometryClearcoatNormal, geometryViewDir, material.clearcoatF0, material.clearcoatF90, material.clearcoatRoughness );
	#endif
	#ifdef USE_SHEEN
		sheenSpecularIndirect += irradiance * material.sheenColor * IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
	#endif
	vec3 singleScattering = vec3( 0.0 );
	vec3 multiScattering = vec3( 0.0 );
	vec3 cosineWeightedIrradiance = irradiance * RECIPROCAL_PI;
	#ifdef USE_IRIDESCENCE
		computeMultiscatteringIridescence( geometryNormal, geometryViewDir, material.specularColor, material.specularF90, material.iridescence, material.iridescenceFresnel, material.roughness, singleScattering, multiScattering );
	#else
		computeMultiscattering( geometryNormal, geometryViewDir, material.specularColor, material.specularF90, material.roughness, singleScattering, multiScattering );
	#endif
	vec3 totalScattering = singleScattering + multiScattering;
	vec3 diffuse = material.diffuseColor * ( 1.0 - max( max( totalScattering.r, totalScattering.g ), totalScattering.b ) );
	reflectedLight.indirectSpecular += radiance * singleScattering;
	reflectedLight.indirectSpecular += multiScattering * cosineWeightedIrradiance;
	reflectedLight.indirectDiffuse += diffuse * cosineWeightedIrradiance;
}
#define RE_Direct				RE_Direct_Physical
#define RE_Direct_RectArea		RE_Direct_RectArea_Physical
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Physical
#define RE_IndirectSpecular		RE_IndirectSpecular_Physical
float computeSpecularOcclusion( const in float dotNV, const in float ambientOcclusion, const in float roughness ) {
	return saturate( pow( dotNV + ambientOcclusion, exp2( - 16.0 * roughness - 1.0 ) ) - 1.0 + ambientOcclusion );
}`,Pw=`
vec3 geometryPosition = - vViewPosition;
vec3 geometryNormal = normal;
vec3 geometryViewDir = ( isOrthographic ) ? vec3( 0, 0, 1 ) : normalize( vViewPosition );
vec3 geometryClearcoatNormal = vec3( 0.0 );
#ifdef USE_CLEARCOAT
	geometryClearcoatNormal = clearcoatNormal;
#endif
#ifdef USE_IRIDESCENCE
	float dotNVi = saturate( dot( normal, geometryViewDir ) );
	if ( material.iridescenceThickness == 0.0 ) {
		material.iridescence = 0.0;
	} else {
		material.iridescence = saturate( material.iridescence );
	}
	if ( material.iridescence > 0.0 ) {
		material.iridescenceFresnel = evalIridescence( 1.0, material.iridescenceIOR, dotNVi, material.iridescenceThickness, material.specularColor );
		material.iridescenceF0 = Schlick_to_F0( material.iridescenceFresnel, 1.0, dotNVi );
	}
#endif
IncidentLight directLight;
#if ( NUM_POINT_LIGHTS > 0 ) && defined( RE_Direct )
	PointLight pointLight;
	#if defined( USE_SHADOWMAP ) && NUM_POINT_LIGHT_SHADOWS > 0
	PointLightShadow pointLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_POINT_LIGHTS; i ++ ) {
		pointLight = pointLights[ i ];
		getPointLightInfo( pointLight, geometryPosition, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_POINT_LIGHT_SHADOWS )
		pointLightShadow = pointLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getPointShadow( pointShadowMap[ i ], pointLightShadow.shadowMapSize, pointLightShadow.shadowIntensity, pointLightShadow.shadowBias, pointLightShadow.shadowRadius, vPointShadowCoord[ i ], pointLightShadow.shadowCameraNear, pointLightShadow.shadowCameraFar ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_SPOT_LIGHTS > 0 ) && defined( RE_Direct )
	SpotLight spotLight;
	vec4 spotColor;
	vec3 spotLightCoord;
	bool inSpotLightMap;
	#if defined( USE_SHADOWMAP ) && NUM_SPOT_LIGHT_SHADOWS > 0
	SpotLightShadow spotLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHTS; i ++ ) {
		spotLight = spotLights[ i ];
		getSpotLightInfo( spotLight, geometryPosition, directLight );
		#if ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )
		#define SPOT_LIGHT_MAP_INDEX UNROLLED_LOOP_INDEX
		#elif ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
		#define SPOT_LIGHT_MAP_INDEX NUM_SPOT_LIGHT_MAPS
		#else
		#define SPOT_LIGHT_MAP_INDEX ( UNROLLED_LOOP_INDEX - NUM_SPOT_LIGHT_SHADOWS + NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )
		#endif
		#if ( SPOT_LIGHT_MAP_INDEX < NUM_SPOT_LIGHT_MAPS )
			spotLightCoord = vSpotLightCoord[ i ].xyz / vSpotLightCoord[ i ].w;
			inSpotLightMap = all( lessThan( abs( spotLightCoord * 2. - 1. ), vec3( 1.0 ) ) );
			spotColor = texture2D( spotLightMap[ SPOT_LIGHT_MAP_INDEX ], spotLightCoord.xy );
			directLight.color = inSpotLightMap ? directLight.color * spotColor.rgb : directLight.color;
		#endif
		#undef SPOT_LIGHT_MAP_INDEX
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
		spotLightShadow = spotLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getShadow( spotShadowMap[ i ], spotLightShadow.shadowMapSize, spotLightShadow.shadowIntensity, spotLightShadow.shadowBias, spotLightShadow.shadowRadius, vSpotLightCoord[ i ] ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_DIR_LIGHTS > 0 ) && defined( RE_Direct )
	DirectionalLight directionalLight;
	#if defined( USE_SHADOWMAP ) && NUM_DIR_LIGHT_SHADOWS > 0
	DirectionalLightShadow directionalLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_DIR_LIGHTS; i ++ ) {
		directionalLight = directionalLights[ i ];
		getDirectionalLightInfo( directionalLight, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_DIR_LIGHT_SHADOWS )
		directionalLightShadow = directionalLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getShadow( directionalShadowMap[ i ], directionalLightShadow.shadowMapSize, directionalLightShadow.shadowIntensity, directionalLightShadow.shadowBias, directionalLightShadow.shadowRadius, vDirectionalShadowCoord[ i ] ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_RECT_AREA_LIGHTS > 0 ) && defined( RE_Direct_RectArea )
	RectAreaLight rectAreaLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_RECT_AREA_LIGHTS; i ++ ) {
		rectAreaLight = rectAreaLights[ i ];
		RE_Direct_RectArea( rectAreaLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if defined( RE_IndirectDiffuse )
	vec3 iblIrradiance = vec3( 0.0 );
	vec3 irradiance = getAmbientLightIrradiance( ambientLightColor );
	#if defined( USE_LIGHT_PROBES )
		irradiance += getLightProbeIrradiance( lightProbe, geometryNormal );
	#endif
	#if ( NUM_HEMI_LIGHTS > 0 )
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_HEMI_LIGHTS; i ++ ) {
			irradiance += getHemisphereLightIrradiance( hemisphereLights[ i ], geometryNormal );
		}
		#pragma unroll_loop_end
	#endif
#endif
#if defined( RE_IndirectSpecular )
	vec3 radiance = vec3( 0.0 );
	vec3 clearcoatRadiance = vec3( 0.0 );
#endif`,Lw=`#if defined( RE_IndirectDiffuse )
	#ifdef USE_LIGHTMAP
		vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
		vec3 lightMapIrradiance = lightMapTexel.rgb * lightMapIntensity;
		irradiance += lightMapIrradiance;
	#endif
	#if defined( USE_ENVMAP ) && defined( STANDARD ) && defined( ENVMAP_TYPE_CUBE_UV )
		iblIrradiance += getIBLIrradiance( geometryNormal );
	#endif
#endif
#if defined( USE_ENVMAP ) && defined( RE_IndirectSpecular )
	#ifdef USE_ANISOTROPY
		radiance += getIBLAnisotropyRadiance( geometryViewDir, geometryNormal, material.roughness, material.anisotropyB, material.anisotropy );
	#else
		radiance += getIBLRadiance( geometryViewDir, geometryNormal, material.roughness );
	#endif
	#ifdef USE_CLEARCOAT
		clearcoatRadiance += getIBLRadiance( geometryViewDir, geometryClearcoatNormal, material.clearcoatRoughness );
	#endif
#endif`,Dw=`#if defined( RE_IndirectDiffuse )
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,Nw=`#if defined( USE_LOGDEPTHBUF )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,Iw=`#if defined( USE_LOGDEPTHBUF )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,Uw=`#ifdef USE_LOGDEPTHBUF
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,Fw=`#ifdef USE_LOGDEPTHBUF
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,Ow=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,kw=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,Bw=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
	#if defined( USE_POINTS_UV )
		vec2 uv = vUv;
	#else
		vec2 uv = ( uvTransform * vec3( gl_PointCoord.x, 1.0 - gl_PointCoord.y, 1 ) ).xy;
	#endif
#endif
#ifdef USE_MAP
	diffuseColor *= texture2D( map, uv );
#endif
#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, uv ).g;
#endif`,zw=`#if defined( USE_POINTS_UV )
	varying vec2 vUv;
#else
	#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
		uniform mat3 uvTransform;
	#endif
#endif
#ifdef USE_MAP
	uniform sampler2D map;
#endif
#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,Hw=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,Vw=`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,Gw=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,Ww=`#if defined( USE_MORPHCOLORS )
	vColor *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		#if defined( USE_COLOR_ALPHA )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor += getMorph( gl_VertexID, i, 2 ) * morphTargetInfluences[ i ];
		#elif defined( USE_COLOR )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor += getMorph( gl_VertexID, i, 2 ).rgb * morphTargetInfluences[ i ];
		#endif
	}
#endif`,$w=`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,Xw=`#ifdef USE_MORPHTARGETS
	#ifndef USE_INSTANCING_MORPH
		uniform float morphTargetBaseInfluence;
		uniform float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	#endif
	uniform sampler2DArray morphTargetsTexture;
	uniform ivec2 morphTargetsTextureSize;
	vec4 getMorph( const in int vertexIndex, const in int morphTargetIndex, const in int offset ) {
		int texelIndex = vertexIndex * MORPHTARGETS_TEXTURE_STRIDE + offset;
		int y = texelIndex / morphTargetsTextureSize.x;
		int x = texelIndex - y * morphTargetsTextureSize.x;
		ivec3 morphUV = ivec3( x, y, morphTargetIndex );
		return texelFetch( morphTargetsTexture, morphUV, 0 );
	}
#endif`,qw=`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,Yw=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
#ifdef FLAT_SHADED
	vec3 fdx = dFdx( vViewPosition );
	vec3 fdy = dFdy( vViewPosition );
	vec3 normal = normalize( cross( fdx, fdy ) );
#else
	vec3 normal = normalize( vNormal );
	#ifdef DOUBLE_SIDED
		normal *= faceDirection;
	#endif
#endif
#if defined( USE_NORMALMAP_TANGENTSPACE ) || defined( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY )
	#ifdef USE_TANGENT
		mat3 tbn = mat3( normalize( vTangent ), normalize( vBitangent ), normal );
	#else
		mat3 tbn = getTangentFrame( - vViewPosition, normal,
		#if defined( USE_NORMALMAP )
			vNormalMapUv
		#elif defined( USE_CLEARCOAT_NORMALMAP )
			vClearcoatNormalMapUv
		#else
			vUv
		#endif
		);
	#endif
	#if defined( DOUBLE_SIDED ) && ! defined( FLAT_SHADED )
		tbn[0] *= faceDirection;
		tbn[1] *= faceDirection;
	#endif
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	#ifdef USE_TANGENT
		mat3 tbn2 = mat3( normalize( vTangent ), normalize( vBitangent ), normal );
	#else
		mat3 tbn2 = getTangentFrame( - vViewPosition, normal, vClearcoatNormalMapUv );
	#endif
	#if defined( DOUBLE_SIDED ) && ! defined( FLAT_SHADED )
		tbn2[0] *= faceDirection;
		tbn2[1] *= faceDirection;
	#endif
#endif
vec3 nonPerturbedNormal = normal;`,jw=`#ifdef USE_NORMALMAP_OBJECTSPACE
	normal = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;
	#ifdef FLIP_SIDED
		normal = - normal;
	#endif
	#ifdef DOUBLE_SIDED
		normal = normal * faceDirection;
	#endif
	normal = normalize( normalMatrix * normal );
#elif defined( USE_NORMALMAP_TANGENTSPACE )
	vec3 mapN = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;
	mapN.xy *= normalScale;
	normal = normalize( tbn * mapN );
#elif defined( USE_BUMPMAP )
	normal = perturbNormalArb( - vViewPosition, normal, dHdxy_fwd(), faceDirection );
#endif`,Kw=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,Zw=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,Jw=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
	#endif
#endif`,Qw=`#ifdef USE_NORMALMAP
	uniform sampler2D normalMap;
	uniform vec2 normalScale;
#endif
#ifdef USE_NORMALMAP_OBJECTSPACE
	uniform mat3 normalMatrix;
#endif
#if ! defined ( USE_TANGENT ) && ( defined ( USE_NORMALMAP_TANGENTSPACE ) || defined ( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY ) )
	mat3 getTangentFrame( vec3 eye_pos, vec3 surf_norm, vec2 uv ) {
		vec3 q0 = dFdx( eye_pos.xyz );
		vec3 q1 = dFdy( eye_pos.xyz );
		vec2 st0 = dFdx( uv.st );
		vec2 st1 = dFdy( uv.st );
		vec3 N = surf_norm;
		vec3 q1perp = cross( q1, N );
		vec3 q0perp = cross( N, q0 );
		vec3 T = q1perp * st0.x + q0perp * st1.x;
		vec3 B = q1perp * st0.y + q0perp * st1.y;
		float det = max( dot( T, T ), dot( B, B ) );
		float scale = ( det == 0.0 ) ? 0.0 : inversesqrt( det );
		return mat3( T * scale, B * scale, N );
	}
#endif`,e1=`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,t1=`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,n1=`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,i1=`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,s1=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,r1=`vec3 packNormalToRGB( const in vec3 normal ) {
	return normalize( normal ) * 0.5 + 0.5;
}
vec3 unpackRGBToNormal( const in vec3 rgb ) {
	return 2.0 * rgb.xyz - 1.0;
}
const float PackUpscale = 256. / 255.;const float UnpackDownscale = 255. / 256.;const float ShiftRight8 = 1. / 256.;
const float Inv255 = 1. / 255.;
const vec4 PackFactors = vec4( 1.0, 256.0, 256.0 * 256.0, 256.0 * 256.0 * 256.0 );
const vec2 UnpackFactors2 = vec2( UnpackDownscale, 1.0 / PackFactors.g );
const vec3 UnpackFactors3 = vec3( UnpackDownscale / PackFactors.rg, 1.0 / PackFactors.b );
const vec4 UnpackFactors4 = vec4( UnpackDownscale / PackFactors.rgb, 1.0 / PackFactors.a );
vec4 packDepthToRGBA( const in float v ) {
	if( v <= 0.0 )
		return vec4( 0., 0., 0., 0. );
	if( v >= 1.0 )
		return vec4( 1., 1., 1., 1. );
	float vuf;
	float af = modf( v * PackFactors.a, vuf );
	float bf = modf( vuf * ShiftRight8, vuf );
	float gf = modf( vuf * ShiftRight8, vuf );
	return vec4( vuf * Inv255, gf * PackUpscale, bf * PackUpscale, af );
}
vec3 packDepthToRGB( const in float v ) {
	if( v <= 0.0 )
		return vec3( 0., 0., 0. );
	if( v >= 1.0 )
		return vec3( 1., 1., 1. );
	float vuf;
	float bf = modf( v * PackFactors.b, vuf );
	float gf = modf( vuf * ShiftRight8, vuf );
	return vec3( vuf * Inv255, gf * PackUpscale, bf );
}
vec2 packDepthToRG( const in float v ) {
	if( v <= 0.0 )
		return vec2( 0., 0. );
	if( v >= 1.0 )
		return vec2( 1., 1. );
	float vuf;
	float gf = modf( v * 256., vuf );
	return vec2( vuf * Inv255, gf );
}
float unpackRGBAToDepth( const in vec4 v ) {
	return dot( v, UnpackFactors4 );
}
float unpackRGBToDepth( const in vec3 v ) {
	return dot( v, UnpackFactors3 );
}
float unpackRGToDepth( const in vec2 v ) {
	return v.r * UnpackFactors2.r + v.g * UnpackFactors2.g;
}
vec4 pack2HalfToRGBA( const in vec2 v ) {
	vec4 r = vec4( v.x, fract( v.x * 255.0 ), v.y, fract( v.y * 255.0 ) );
	return vec4( r.x - r.y / 255.0, r.y, r.z - r.w / 255.0, r.w );
}
vec2 unpackRGBATo2Half( const in vec4 v ) {
	return vec2( v.x + ( v.y / 255.0 ), v.z + ( v.w / 255.0 ) );
}
float viewZToOrthographicDepth( const in float viewZ, const in float near, const in float far ) {
	return ( viewZ + near ) / ( near - far );
}
float orthographicDepthToViewZ( const in float depth, const in float near, const in float far ) {
	return depth * ( near - far ) - near;
}
float viewZToPerspectiveDepth( const in float viewZ, const in float near, const in float far ) {
	return ( ( near + viewZ ) * far ) / ( ( far - near ) * viewZ );
}
float perspectiveDepthToViewZ( const in float depth, const in float near, const in float far ) {
	return ( near * far ) / ( ( far - near ) * depth - far );
}`,o1=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,a1=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,l1=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,c1=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,u1=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,h1=`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,d1=`#if NUM_SPOT_LIGHT_COORDS > 0
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#if NUM_SPOT_LIGHT_MAPS > 0
	uniform sampler2D spotLightMap[ NUM_SPOT_LIGHT_MAPS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_DIR_LIGHT_SHADOWS > 0
		uniform sampler2D directionalShadowMap[ NUM_DIR_LIGHT_SHADOWS ];
		varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];
		struct DirectionalLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
		uniform sampler2D spotShadowMap[ NUM_SPOT_LIGHT_SHADOWS ];
		struct SpotLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SpotLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		uniform sampler2D pointShadowMap[ NUM_POINT_LIGHT_SHADOWS ];
		varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];
		struct PointLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
			float shadowCameraNear;
			float shadowCameraFar;
		};
		uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];
	#endif
	float texture2DCompare( sampler2D depths, vec2 uv, float compare ) {
		return step( compare, unpackRGBAToDepth( texture2D( depths, uv ) ) );
	}
	vec2 texture2DDistribution( sampler2D shadow, vec2 uv ) {
		return unpackRGBATo2Half( texture2D( shadow, uv ) );
	}
	float VSMShadow (sampler2D shadow, vec2 uv, float compare ){
		float occlusion = 1.0;
		vec2 distribution = texture2DDistribution( shadow, uv );
		float hard_shadow = step( compare , distribution.x );
		if (hard_shadow != 1.0 ) {
			float distance = compare - distribution.x ;
			float variance = max( 0.00000, distribution.y * distribution.y );
			float softness_probability = variance / (variance + distance * distance );			softness_probability = clamp( ( softness_probability - 0.3 ) / ( 0.95 - 0.3 ), 0.0, 1.0 );			occlusion = clamp( max( hard_shadow, softness_probability ), 0.0, 1.0 );
		}
		return occlusion;
	}
	float getShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
		float shadow = 1.0;
		shadowCoord.xyz /= shadowCoord.w;
		shadowCoord.z += shadowBias;
		bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
		bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
		if ( frustumTest ) {
		#if defined( SHADOWMAP_TYPE_PCF )
			vec2 texelSize = vec2( 1.0 ) / shadowMapSize;
			float dx0 = - texelSize.x * shadowRadius;
			float dy0 = - texelSize.y * shadowRadius;
			float dx1 = + texelSize.x * shadowRadius;
			float dy1 = + texelSize.y * shadowRadius;
			float dx2 = dx0 / 2.0;
			float dy2 = dy0 / 2.0;
			float dx3 = dx1 / 2.0;
			float dy3 = dy1 / 2.0;
			shadow = (
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx0, dy0 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( 0.0, dy0 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx1, dy0 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx2, dy2 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( 0.0, dy2 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx3, dy2 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx0, 0.0 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx2, 0.0 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy, shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx3, 0.0 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx1, 0.0 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx2, dy3 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( 0.0, dy3 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx3, dy3 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx0, dy1 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( 0.0, dy1 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx1, dy1 ), shadowCoord.z )
			) * ( 1.0 / 17.0 );
		#elif defined( SHADOWMAP_TYPE_PCF_SOFT )
			vec2 texelSize = vec2( 1.0 ) / shadowMapSize;
			float dx = texelSize.x;
			float dy = texelSize.y;
			vec2 uv = shadowCoord.xy;
			vec2 f = fract( uv * shadowMapSize + 0.5 );
			uv -= f * texelSize;
			shadow = (
				texture2DCompare( shadowMap, uv, shadowCoord.z ) +
				texture2DCompare( shadowMap, uv + vec2( dx, 0.0 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, uv + vec2( 0.0, dy ), shadowCoord.z ) +
				texture2DCompare( shadowMap, uv + texelSize, shadowCoord.z ) +
				mix( texture2DCompare( shadowMap, uv + vec2( -dx, 0.0 ), shadowCoord.z ),
					 texture2DCompare( shadowMap, uv + vec2( 2.0 * dx, 0.0 ), shadowCoord.z ),
					 f.x ) +
				mix( texture2DCompare( shadowMap, uv + vec2( -dx, dy ), shadowCoord.z ),
					 texture2DCompare( shadowMap, uv + vec2( 2.0 * dx, dy ), shadowCoord.z ),
					 f.x ) +
				mix( texture2DCompare( shadowMap, uv + vec2( 0.0, -dy ), shadowCoord.z ),
					 texture2DCompare( shadowMap, uv + vec2( 0.0, 2.0 * dy ), shadowCoord.z ),
					 f.y ) +
				mix( texture2DCompare( shadowMap, uv + vec2( dx, -dy ), shadowCoord.z ),
					 texture2DCompare( shadowMap, uv + vec2( dx, 2.0 * dy ), shadowCoord.z ),
					 f.y ) +
				mix( mix( texture2DCompare( shadowMap, uv + vec2( -dx, -dy ), shadowCoord.z ),
						  texture2DCompare( shadowMap, uv + vec2( 2.0 * dx, -dy ), shadowCoord.z ),
						  f.x ),
					 mix( texture2DCompare( shadowMap, uv + vec2( -dx, 2.0 * dy ), shadowCoord.z ),
						  texture2DCompare( shadowMap, uv + vec2( 2.0 * dx, 2.0 * dy ), shadowCoord.z ),
						  f.x ),
					 f.y )
			) * ( 1.0 / 9.0 );
		#elif defined( SHADOWMAP_TYPE_VSM )
			shadow = VSMShadow( shadowMap, shadowCoord.xy, shadowCoord.z );
		#else
			shadow = texture2DCompare( shadowMap, shadowCoord.xy, shadowCoord.z );
		#endif
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
	vec2 cubeToUV( vec3 v, float texelSizeY ) {
		vec3 absV = abs( v );
		float scaleToCube = 1.0 / max( absV.x, max( absV.y, absV.z ) );
		absV *= scaleToCube;
		v *= scaleToCube * ( 1.0 - 2.0 * texelSizeY );
		vec2 planar = v.xy;
		float almostATexel = 1.5 * texelSizeY;
		float almostOne = 1.0 - almostATexel;
		if ( absV.z >= almostOne ) {
			if ( v.z > 0.0 )
				planar.x = 4.0 - v.x;
		} else if ( absV.x >= almostOne ) {
			float signX = sign( v.x );
			planar.x = v.z * signX + 2.0 * signX;
		} else if ( absV.y >= almostOne ) {
			float signY = sign( v.y );
			planar.x = v.x + 2.0 * signY + 2.0;
			planar.y = v.z * signY - 2.0;
		}
		return vec2( 0.125, 0.25 ) * planar + vec2( 0.375, 0.75 );
	}
	float getPointShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord, float shadowCameraNear, float shadowCameraFar ) {
		float shadow = 1.0;
		vec3 lightToPosition = shadowCoord.xyz;
		
		float lightToPositionLength = length( lightToPosition );
		if ( lightToPositionLength - shadowCameraFar <= 0.0 && lightToPositionLength - shadowCameraNear >= 0.0 ) {
			float dp = ( lightToPositionLength - shadowCameraNear ) / ( shadowCameraFar - shadowCameraNear );			dp += shadowBias;
			vec3 bd3D = normalize( lightToPosition );
			vec2 texelSize = vec2( 1.0 ) / ( shadowMapSize * vec2( 4.0, 2.0 ) );
			#if defined( SHADOWMAP_TYPE_PCF ) || defined( SHADOWMAP_TYPE_PCF_SOFT ) || defined( SHADOWMAP_TYPE_VSM )
				vec2 offset = vec2( - 1, 1 ) * shadowRadius * texelSize.y;
				shadow = (
					texture2DCompare( shadowMap, cubeToUV( bd3D + offset.xyy, texelSize.y ), dp ) +
					texture2DCompare( shadowMap, cubeToUV( bd3D + offset.yyy, texelSize.y ), dp ) +
					texture2DCompare( shadowMap, cubeToUV( bd3D + offset.xyx, texelSize.y ), dp ) +
					texture2DCompare( shadowMap, cubeToUV( bd3D + offset.yyx, texelSize.y ), dp ) +
					texture2DCompare( shadowMap, cubeToUV( bd3D, texelSize.y ), dp ) +
					texture2DCompare( shadowMap, cubeToUV( bd3D + offset.xxy, texelSize.y ), dp ) +
					texture2DCompare( shadowMap, cubeToUV( bd3D + offset.yxy, texelSize.y ), dp ) +
					texture2DCompare( shadowMap, cubeToUV( bd3D + offset.xxx, texelSize.y ), dp ) +
					texture2DCompare( shadowMap, cubeToUV( bd3D + offset.yxx, texelSize.y ), dp )
				) * ( 1.0 / 9.0 );
			#else
				shadow = texture2DCompare( shadowMap, cubeToUV( bd3D, texelSize.y ), dp );
			#endif
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
#endif`,f1=`#if NUM_SPOT_LIGHT_COORDS > 0
	uniform mat4 spotLightMatrix[ NUM_SPOT_LIGHT_COORDS ];
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_DIR_LIGHT_SHADOWS > 0
		uniform mat4 directionalShadowMatrix[ NUM_DIR_LIGHT_SHADOWS ];
		varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];
		struct DirectionalLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
		struct SpotLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SpotLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		uniform mat4 pointShadowMatrix[ NUM_POINT_LIGHT_SHADOWS ];
		varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];
		struct PointLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
			float shadowCameraNear;
			float shadowCameraFar;
		};
		uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];
	#endif
#endif`,p1=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
	vec3 shadowWorldNormal = inverseTransformDirection( transformedNormal, viewMatrix );
	vec4 shadowWorldPosition;
#endif
#if defined( USE_SHADOWMAP )
	#if NUM_DIR_LIGHT_SHADOWS > 0
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_DIR_LIGHT_SHADOWS; i ++ ) {
			shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * directionalLightShadows[ i ].shadowNormalBias, 0 );
			vDirectionalShadowCoord[ i ] = directionalShadowMatrix[ i ] * shadowWorldPosition;
		}
		#pragma unroll_loop_end
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {
			shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * pointLightShadows[ i ].shadowNormalBias, 0 );
			vPointShadowCoord[ i ] = pointShadowMatrix[ i ] * shadowWorldPosition;
		}
		#pragma unroll_loop_end
	#endif
#endif
#if NUM_SPOT_LIGHT_COORDS > 0
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHT_COORDS; i ++ ) {
		shadowWorldPosition = worldPosition;
		#if ( defined( USE_SHADOWMAP ) && UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
			shadowWorldPosition.xyz += shadowWorldNormal * spotLightShadows[ i ].shadowNormalBias;
		#endif
		vSpotLightCoord[ i ] = spotLightMatrix[ i ] * shadowWorldPosition;
	}
	#pragma unroll_loop_end
#endif`,m1=`float getShadowMask() {
	float shadow = 1.0;
	#ifdef USE_SHADOWMAP
	#if NUM_DIR_LIGHT_SHADOWS > 0
	DirectionalLightShadow directionalLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_DIR_LIGHT_SHADOWS; i ++ ) {
		directionalLight = directionalLightShadows[ i ];
		shadow *= receiveShadow ? getShadow( directionalShadowMap[ i ], directionalLight.shadowMapSize, directionalLight.shadowIntensity, directionalLight.shadowBias, directionalLight.shadowRadius, vDirectionalShadowCoord[ i ] ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
	SpotLightShadow spotLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHT_SHADOWS; i ++ ) {
		spotLight = spotLightShadows[ i ];
		shadow *= receiveShadow ? getShadow( spotShadowMap[ i ], spotLight.shadowMapSize, spotLight.shadowIntensity, spotLight.shadowBias, spotLight.shadowRadius, vSpotLightCoord[ i ] ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
	PointLightShadow pointLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {
		pointLight = pointLightShadows[ i ];
		shadow *= receiveShadow ? getPointShadow( pointShadowMap[ i ], pointLight.shadowMapSize, pointLight.shadowIntensity, pointLight.shadowBias, pointLight.shadowRadius, vPointShadowCoord[ i ], pointLight.shadowCameraNear, pointLight.shadowCameraFar ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#endif
	return shadow;
}`,g1=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,_1=`#ifdef USE_SKINNING
	uniform mat4 bindMatrix;
	uniform mat4 bindMatrixInverse;
	uniform highp sampler2D boneTexture;
	mat4 getBoneMatrix( const in float i ) {
		int size = textureSize( boneTexture, 0 ).x;
		int j = int( i ) * 4;
		int x = j % size;
		int y = j / size;
		vec4 v1 = texelFetch( boneTexture, ivec2( x, y ), 0 );
		vec4 v2 = texelFetch( boneTexture, ivec2( x + 1, y ), 0 );
		vec4 v3 = texelFetch( boneTexture, ivec2( x + 2, y ), 0 );
		vec4 v4 = texelFetch( boneTexture, ivec2( x + 3, y ), 0 );
		return mat4( v1, v2, v3, v4 );
	}
#endif`,v1=`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,x1=`#ifdef USE_SKINNING
	mat4 skinMatrix = mat4( 0.0 );
	skinMatrix += skinWeight.x * boneMatX;
	skinMatrix += skinWeight.y * boneMatY;
	skinMatrix += skinWeight.z * boneMatZ;
	skinMatrix += skinWeight.w * boneMatW;
	skinMatrix = bindMatrixInverse * skinMatrix * bindMatrix;
	objectNormal = vec4( skinMatrix * vec4( objectNormal, 0.0 ) ).xyz;
	#ifdef USE_TANGENT
		objectTangent = vec4( skinMatrix * vec4( objectTangent, 0.0 ) ).xyz;
	#endif
#endif`,M1=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,S1=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,y1=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,b1=`#ifndef saturate
#define saturate( a ) clamp( a, 0.0, 1.0 )
#endif
uniform float toneMappingExposure;
vec3 LinearToneMapping( vec3 color ) {
	return saturate( toneMappingExposure * color );
}
vec3 ReinhardToneMapping( vec3 color ) {
	color *= toneMappingExposure;
	return saturate( color / ( vec3( 1.0 ) + color ) );
}
vec3 CineonToneMapping( vec3 color ) {
	color *= toneMappingExposure;
	color = max( vec3( 0.0 ), color - 0.004 );
	return pow( ( color * ( 6.2 * color + 0.5 ) ) / ( color * ( 6.2 * color + 1.7 ) + 0.06 ), vec3( 2.2 ) );
}
vec3 RRTAndODTFit( vec3 v ) {
	vec3 a = v * ( v + 0.0245786 ) - 0.000090537;
	vec3 b = v * ( 0.983729 * v + 0.4329510 ) + 0.238081;
	return a / b;
}
vec3 ACESFilmicToneMapping( vec3 color ) {
	const mat3 ACESInputMat = mat3(
		vec3( 0.59719, 0.07600, 0.02840 ),		vec3( 0.35458, 0.90834, 0.13383 ),
		vec3( 0.04823, 0.01566, 0.83777 )
	);
	const mat3 ACESOutputMat = mat3(
		vec3(  1.60475, -0.10208, -0.00327 ),		vec3( -0.53108,  1.10813, -0.07276 ),
		vec3( -0.07367, -0.00605,  1.07602 )
	);
	color *= toneMappingExposure / 0.6;
	color = ACESInputMat * color;
	color = RRTAndODTFit( color );
	color = ACESOutputMat * color;
	return saturate( color );
}
const mat3 LINEAR_REC2020_TO_LINEAR_SRGB = mat3(
	vec3( 1.6605, - 0.1246, - 0.0182 ),
	vec3( - 0.5876, 1.1329, - 0.1006 ),
	vec3( - 0.0728, - 0.0083, 1.1187 )
);
const mat3 LINEAR_SRGB_TO_LINEAR_REC2020 = mat3(
	vec3( 0.6274, 0.0691, 0.0164 ),
	vec3( 0.3293, 0.9195, 0.0880 ),
	vec3( 0.0433, 0.0113, 0.8956 )
);
vec3 agxDefaultContrastApprox( vec3 x ) {
	vec3 x2 = x * x;
	vec3 x4 = x2 * x2;
	return + 15.5 * x4 * x2
		- 40.14 * x4 * x
		+ 31.96 * x4
		- 6.868 * x2 * x
		+ 0.4298 * x2
		+ 0.1191 * x
		- 0.00232;
}
vec3 AgXToneMapping( vec3 color ) {
	const mat3 AgXInsetMatrix = mat3(
		vec3( 0.856627153315983, 0.137318972929847, 0.11189821299995 ),
		vec3( 0.0951212405381588, 0.761241990602591, 0.0767994186031903 ),
		vec3( 0.0482516061458583, 0.101439036467562, 0.811302368396859 )
	);
	const mat3 AgXOutsetMatrix = mat3(
		vec3( 1.1271005818144368, - 0.1413297634984383, - 0.14132976349843826 ),
		vec3( - 0.11060664309660323, 1.157823702216272, - 0.11060664309660294 ),
		vec3( - 0.016493938717834573, - 0.016493938717834257, 1.2519364065950405 )
	);
	const float AgxMinEv = - 12.47393;	const float AgxMaxEv = 4.026069;
	color *= toneMappingExposure;
	color = LINEAR_SRGB_TO_LINEAR_REC2020 * color;
	color = AgXInsetMatrix * color;
	color = max( color, 1e-10 );	color = log2( color );
	color = ( color - AgxMinEv ) / ( AgxMaxEv - AgxMinEv );
	color = clamp( color, 0.0, 1.0 );
	color = agxDefaultContrastApprox( color );
	color = AgXOutsetMatrix * color;
	color = pow( max( vec3( 0.0 ), color ), vec3( 2.2 ) );
	color = LINEAR_REC2020_TO_LINEAR_SRGB * color;
	color = clamp( color, 0.0, 1.0 );
	return color;
}
vec3 NeutralToneMapping( vec3 color ) {
	const float StartCompression = 0.8 - 0.04;
	const float Desaturation = 0.15;
	color *= toneMappingExposure;
	float x = min( color.r, min( color.g, color.b ) );
	float offset = x < 0.08 ? x - 6.25 * x * x : 0.04;
	color -= offset;
	float peak = max( color.r, max( color.g, color.b ) );
	if ( peak < StartCompression ) return color;
	float d = 1. - StartCompression;
	float newPeak = 1. - d * d / ( peak + d - StartCompression );
	color *= newPeak / peak;
	float g = 1. - 1. / ( Desaturation * ( peak - newPeak ) + 1. );
	return mix( color, vec3( newPeak ), g );
}
vec3 CustomToneMapping( vec3 color ) { return color; }`,E1=`#ifdef USE_TRANSMISSION
	material.transmission = transmission;
	material.transmissionAlpha = 1.0;
	material.thickness = thickness;
	material.attenuationDistance = attenuationDistance;
	material.attenuationColor = attenuationColor;
	#ifdef USE_TRANSMISSIONMAP
		material.transmission *= texture2D( transmissionMap, vTransmissionMapUv ).r;
	#endif
	#ifdef USE_THICKNESSMAP
		material.thickness *= texture2D( thicknessMap, vThicknessMapUv ).g;
	#endif
	vec3 pos = vWorldPosition;
	vec3 v = normalize( cameraPosition - pos );
	vec3 n = inverseTransformDirection( normal, viewMatrix );
	vec4 transmitted = getIBLVolumeRefraction(
		n, v, material.roughness, material.diffuseColor, material.specularColor, material.specularF90,
		pos, modelMatrix, viewMatrix, projectionMatrix, material.dispersion, material.ior, material.thickness,
		material.attenuationColor, material.attenuationDistance );
	material.transmissionAlpha = mix( material.transmissionAlpha, transmitted.a, material.transmission );
	totalDiffuse = mix( totalDiffuse, transmitted.rgb, material.transmission );
#endif`,w1=`#ifdef USE_TRANSMISSION
	uniform float transmission;
	uniform float thickness;
	uniform float attenuationDistance;
	uniform vec3 attenuationColor;
	#ifdef USE_TRANSMISSIONMAP
		uniform sampler2D transmissionMap;
	#endif
	#ifdef USE_THICKNESSMAP
		uniform sampler2D thicknessMap;
	#endif
	uniform vec2 transmissionSamplerSize;
	uniform sampler2D transmissionSamplerMap;
	uniform mat4 modelMatrix;
	uniform mat4 projectionMatrix;
	varying vec3 vWorldPosition;
	float w0( float a ) {
		return ( 1.0 / 6.0 ) * ( a * ( a * ( - a + 3.0 ) - 3.0 ) + 1.0 );
	}
	float w1( float a ) {
		return ( 1.0 / 6.0 ) * ( a *  a * ( 3.0 * a - 6.0 ) + 4.0 );
	}
	float w2( float a ){
		return ( 1.0 / 6.0 ) * ( a * ( a * ( - 3.0 * a + 3.0 ) + 3.0 ) + 1.0 );
	}
	float w3( float a ) {
		return ( 1.0 / 6.0 ) * ( a * a * a );
	}
	float g0( float a ) {
		return w0( a ) + w1( a );
	}
	float g1( float a ) {
		return w2( a ) + w3( a );
	}
	float h0( float a ) {
		return - 1.0 + w1( a ) / ( w0( a ) + w1( a ) );
	}
	float h1( float a ) {
		return 1.0 + w3( a ) / ( w2( a ) + w3( a ) );
	}
	vec4 bicubic( sampler2D tex, vec2 uv, vec4 texelSize, float lod ) {
		uv = uv * texelSize.zw + 0.5;
		vec2 iuv = floor( uv );
		vec2 fuv = fract( uv );
		float g0x = g0( fuv.x );
		float g1x = g1( fuv.x );
		float h0x = h0( fuv.x );
		float h1x = h1( fuv.x );
		float h0y = h0( fuv.y );
		float h1y = h1( fuv.y );
		vec2 p0 = ( vec2( iuv.x + h0x, iuv.y + h0y ) - 0.5 ) * texelSize.xy;
		vec2 p1 = ( vec2( iuv.x + h1x, iuv.y + h0y ) - 0.5 ) * texelSize.xy;
		vec2 p2 = ( vec2( iuv.x + h0x, iuv.y + h1y ) - 0.5 ) * texelSize.xy;
		vec2 p3 = ( vec2( iuv.x + h1x, iuv.y + h1y ) - 0.5 ) * texelSize.xy;
		return g0( fuv.y ) * ( g0x * textureLod( tex, p0, lod ) + g1x * textureLod( tex, p1, lod ) ) +
			g1( fuv.y ) * ( g0x * textureLod( tex, p2, lod ) + g1x * textureLod( tex, p3, lod ) );
	}
	vec4 textureBicubic( sampler2D sampler, vec2 uv, float lod ) {
		vec2 fLodSize = vec2( textureSize( sampler, int( lod ) ) );
		vec2 cLodSize = vec2( textureSize( sampler, int( lod + 1.0 ) ) );
		vec2 fLodSizeInv = 1.0 / fLodSize;
		vec2 cLodSizeInv = 1.0 / cLodSize;
		vec4 fSample = bicubic( sampler, uv, vec4( fLodSizeInv, fLodSize ), floor( lod ) );
		vec4 cSample = bicubic( sampler, uv, vec4( cLodSizeInv, cLodSize ), ceil( lod ) );
		return mix( fSample, cSample, fract( lod ) );
	}
	vec3 getVolumeTransmissionRay( const in vec3 n, const in vec3 v, const in float thickness, const in float ior, const in mat4 modelMatrix ) {
		vec3 refractionVector = refract( - v, normalize( n ), 1.0 / ior );
		vec3 modelScale;
		modelScale.x = length( vec3( modelMatrix[ 0 ].xyz ) );
		modelScale.y = length( vec3( modelMatrix[ 1 ].xyz ) );
		modelScale.z = length( vec3( modelMatrix[ 2 ].xyz ) );
		return normalize( refractionVector ) * thickness * modelScale;
	}
	float applyIorToRoughness( const in float roughness, const in float ior ) {
		return roughness * clamp( ior * 2.0 - 2.0, 0.0, 1.0 );
	}
	vec4 getTransmissionSample( const in vec2 fragCoord, const in float roughness, const in float ior ) {
		float lod = log2( transmissionSamplerSize.x ) * applyIorToRoughness( roughness, ior );
		return textureBicubic( transmissionSamplerMap, fragCoord.xy, lod );
	}
	vec3 volumeAttenuation( const in float transmissionDistance, const in vec3 attenuationColor, const in float attenuationDistance ) {
		if ( isinf( attenuationDistance ) ) {
			return vec3( 1.0 );
		} else {
			vec3 attenuationCoefficient = -log( attenuationColor ) / attenuationDistance;
			vec3 transmittance = exp( - attenuationCoefficient * transmissionDistance );			return transmittance;
		}
	}
	vec4 getIBLVolumeRefraction( const in vec3 n, const in vec3 v, const in float roughness, const in vec3 diffuseColor,
		const in vec3 specularColor, const in float specularF90, const in vec3 position, const in mat4 modelMatrix,
		const in mat4 viewMatrix, const in mat4 projMatrix, const in float dispersion, const in float ior, const in float thickness,
		const in vec3 attenuationColor, const in float attenuationDistance ) {
		vec4 transmittedLight;
		vec3 transmittance;
		#ifdef USE_DISPERSION
			float halfSpread = ( ior - 1.0 ) * 0.025 * dispersion;
			vec3 iors = vec3( ior - halfSpread, ior, ior + halfSpread );
			for ( int i = 0; i < 3; i ++ ) {
				vec3 transmissionRay = getVolumeTransmissionRay( n, v, thickness, iors[ i ], modelMatrix );
				vec3 refractedRayExit = position + transmissionRay;
		
				vec4 ndcPos = projMatrix * viewMatrix * vec4( refractedRayExit, 1.0 );
				vec2 refractionCoords = ndcPos.xy / ndcPos.w;
				refractionCoords += 1.0;
				refractionCoords /= 2.0;
		
				vec4 transmissionSample = getTransmissionSample( refractionCoords, roughness, iors[ i ] );
				transmittedLight[ i ] = transmissionSample[ i ];
				transmittedLight.a += transmissionSample.a;
				transmittance[ i ] = diffuseColor[ i ] * volumeAttenuation( length( transmissionRay ), attenuationColor, attenuationDistance )[ i ];
			}
			transmittedLight.a /= 3.0;
		
		#else
		
			vec3 transmissionRay = getVolumeTransmissionRay( n, v, thickness, ior, modelMatrix );
			vec3 refractedRayExit = position + transmissionRay;
			vec4 ndcPos = projMatrix * viewMatrix * vec4( refractedRayExit, 1.0 );
			vec2 refractionCoords = ndcPos.xy / ndcPos.w;
			refractionCoords += 1.0;
			refractionCoords /= 2.0;
			transmittedLight = getTransmissionSample( refractionCoords, roughness, ior );
			transmittance = diffuseColor * volumeAttenuation( length( transmissionRay ), attenuationColor, attenuationDistance );
		
		#endif
		vec3 attenuatedColor = transmittance * transmittedLight.rgb;
		vec3 F = EnvironmentBRDF( n, v, specularColor, specularF90, roughness );
		float transmittanceFactor = ( transmittance.r + transmittance.g + transmittance.b ) / 3.0;
		return vec4( ( 1.0 - F ) * attenuatedColor, 1.0 - ( 1.0 - transmittedLight.a ) * transmittanceFactor );
	}
#endif`,T1=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	varying vec2 vUv;
#endif
#ifdef USE_MAP
	varying vec2 vMapUv;
#endif
#ifdef USE_ALPHAMAP
	varying vec2 vAlphaMapUv;
#endif
#ifdef USE_LIGHTMAP
	varying vec2 vLightMapUv;
#endif
#ifdef USE_AOMAP
	varying vec2 vAoMapUv;
#endif
#ifdef USE_BUMPMAP
	varying vec2 vBumpMapUv;
#endif
#ifdef USE_NORMALMAP
	varying vec2 vNormalMapUv;
#endif
#ifdef USE_EMISSIVEMAP
	varying vec2 vEmissiveMapUv;
#endif
#ifdef USE_METALNESSMAP
	varying vec2 vMetalnessMapUv;
#endif
#ifdef USE_ROUGHNESSMAP
	varying vec2 vRoughnessMapUv;
#endif
#ifdef USE_ANISOTROPYMAP
	varying vec2 vAnisotropyMapUv;
#endif
#ifdef USE_CLEARCOATMAP
	varying vec2 vClearcoatMapUv;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	varying vec2 vClearcoatNormalMapUv;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	varying vec2 vClearcoatRoughnessMapUv;
#endif
#ifdef USE_IRIDESCENCEMAP
	varying vec2 vIridescenceMapUv;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	varying vec2 vIridescenceThicknessMapUv;
#endif
#ifdef USE_SHEEN_COLORMAP
	varying vec2 vSheenColorMapUv;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	varying vec2 vSheenRoughnessMapUv;
#endif
#ifdef USE_SPECULARMAP
	varying vec2 vSpecularMapUv;
#endif
#ifdef USE_SPECULAR_COLORMAP
	varying vec2 vSpecularColorMapUv;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	varying vec2 vSpecularIntensityMapUv;
#endif
#ifdef USE_TRANSMISSIONMAP
	uniform mat3 transmissionMapTransform;
	varying vec2 vTransmissionMapUv;
#endif
#ifdef USE_THICKNESSMAP
	uniform mat3 thicknessMapTransform;
	varying vec2 vThicknessMapUv;
#endif`,A1=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	varying vec2 vUv;
#endif
#ifdef USE_MAP
	uniform mat3 mapTransform;
	varying vec2 vMapUv;
#endif
#ifdef USE_ALPHAMAP
	uniform mat3 alphaMapTransform;
	varying vec2 vAlphaMapUv;
#endif
#ifdef USE_LIGHTMAP
	uniform mat3 lightMapTransform;
	varying vec2 vLightMapUv;
#endif
#ifdef USE_AOMAP
	uniform mat3 aoMapTransform;
	varying vec2 vAoMapUv;
#endif
#ifdef USE_BUMPMAP
	uniform mat3 bumpMapTransform;
	varying vec2 vBumpMapUv;
#endif
#ifdef USE_NORMALMAP
	uniform mat3 normalMapTransform;
	varying vec2 vNormalMapUv;
#endif
#ifdef USE_DISPLACEMENTMAP
	uniform mat3 displacementMapTransform;
	varying vec2 vDisplacementMapUv;
#endif
#ifdef USE_EMISSIVEMAP
	uniform mat3 emissiveMapTransform;
	varying vec2 vEmissiveMapUv;
#endif
#ifdef USE_METALNESSMAP
	uniform mat3 metalnessMapTransform;
	varying vec2 vMetalnessMapUv;
#endif
#ifdef USE_ROUGHNESSMAP
	uniform mat3 roughnessMapTransform;
	varying vec2 vRoughnessMapUv;
#endif
#ifdef USE_ANISOTROPYMAP
	uniform mat3 anisotropyMapTransform;
	varying vec2 vAnisotropyMapUv;
#endif
#ifdef USE_CLEARCOATMAP
	uniform mat3 clearcoatMapTransform;
	varying vec2 vClearcoatMapUv;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform mat3 clearcoatNormalMapTransform;
	varying vec2 vClearcoatNormalMapUv;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform mat3 clearcoatRoughnessMapTransform;
	varying vec2 vClearcoatRoughnessMapUv;
#endif
#ifdef USE_SHEEN_COLORMAP
	uniform mat3 sheenColorMapTransform;
	varying vec2 vSheenColorMapUv;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	uniform mat3 sheenRoughnessMapTransform;
	varying vec2 vSheenRoughnessMapUv;
#endif
#ifdef USE_IRIDESCENCEMAP
	uniform mat3 iridescenceMapTransform;
	varying vec2 vIridescenceMapUv;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform mat3 iridescenceThicknessMapTransform;
	varying vec2 vIridescenceThicknessMapUv;
#endif
#ifdef USE_SPECULARMAP
	uniform mat3 specularMapTransform;
	varying vec2 vSpecularMapUv;
#endif
#ifdef USE_SPECULAR_COLORMAP
	uniform mat3 specularColorMapTransform;
	varying vec2 vSpecularColorMapUv;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	uniform mat3 specularIntensityMapTransform;
	varying vec2 vSpecularIntensityMapUv;
#endif
#ifdef USE_TRANSMISSIONMAP
	uniform mat3 transmissionMapTransform;
	varying vec2 vTransmissionMapUv;
#endif
#ifdef USE_THICKNESSMAP
	uniform mat3 thicknessMapTransform;
	varying vec2 vThicknessMapUv;
#endif`,R1=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	vUv = vec3( uv, 1 ).xy;
#endif
#ifdef USE_MAP
	vMapUv = ( mapTransform * vec3( MAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ALPHAMAP
	vAlphaMapUv = ( alphaMapTransform * vec3( ALPHAMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_LIGHTMAP
	vLightMapUv = ( lightMapTransform * vec3( LIGHTMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_AOMAP
	vAoMapUv = ( aoMapTransform * vec3( AOMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_BUMPMAP
	vBumpMapUv = ( bumpMapTransform * vec3( BUMPMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_NORMALMAP
	vNormalMapUv = ( normalMapTransform * vec3( NORMALMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_DISPLACEMENTMAP
	vDisplacementMapUv = ( displacementMapTransform * vec3( DISPLACEMENTMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_EMISSIVEMAP
	vEmissiveMapUv = ( emissiveMapTransform * vec3( EMISSIVEMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_METALNESSMAP
	vMetalnessMapUv = ( metalnessMapTransform * vec3( METALNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ROUGHNESSMAP
	vRoughnessMapUv = ( roughnessMapTransform * vec3( ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ANISOTROPYMAP
	vAnisotropyMapUv = ( anisotropyMapTransform * vec3( ANISOTROPYMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOATMAP
	vClearcoatMapUv = ( clearcoatMapTransform * vec3( CLEARCOATMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	vClearcoatNormalMapUv = ( clearcoatNormalMapTransform * vec3( CLEARCOAT_NORMALMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	vClearcoatRoughnessMapUv = ( clearcoatRoughnessMapTransform * vec3( CLEARCOAT_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_IRIDESCENCEMAP
	vIridescenceMapUv = ( iridescenceMapTransform * vec3( IRIDESCENCEMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	vIridescenceThicknessMapUv = ( iridescenceThicknessMapTransform * vec3( IRIDESCENCE_THICKNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SHEEN_COLORMAP
	vSheenColorMapUv = ( sheenColorMapTransform * vec3( SHEEN_COLORMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	vSheenRoughnessMapUv = ( sheenRoughnessMapTransform * vec3( SHEEN_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULARMAP
	vSpecularMapUv = ( specularMapTransform * vec3( SPECULARMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULAR_COLORMAP
	vSpecularColorMapUv = ( specularColorMapTransform * vec3( SPECULAR_COLORMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	vSpecularIntensityMapUv = ( specularIntensityMapTransform * vec3( SPECULAR_INTENSITYMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_TRANSMISSIONMAP
	vTransmissionMapUv = ( transmissionMapTransform * vec3( TRANSMISSIONMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_THICKNESSMAP
	vThicknessMapUv = ( thicknessMapTransform * vec3( THICKNESSMAP_UV, 1 ) ).xy;
#endif`,C1=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`;const P1=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,L1=`uniform sampler2D t2D;
uniform float backgroundIntensity;
varying vec2 vUv;
void main() {
	vec4 texColor = texture2D( t2D, vUv );
	#ifdef DECODE_VIDEO_TEXTURE
		texColor = vec4( mix( pow( texColor.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), texColor.rgb * 0.0773993808, vec3( lessThanEqual( texColor.rgb, vec3( 0.04045 ) ) ) ), texColor.w );
	#endif
	texColor.rgb *= backgroundIntensity;
	gl_FragColor = texColor;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,D1=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,N1=`#ifdef ENVMAP_TYPE_CUBE
	uniform samplerCube envMap;
#elif defined( ENVMAP_TYPE_CUBE_UV )
	uniform sampler2D envMap;
#endif
uniform float flipEnvMap;
uniform float backgroundBlurriness;
uniform float backgroundIntensity;
uniform mat3 backgroundRotation;
varying vec3 vWorldDirection;
#include <cube_uv_reflection_fragment>
void main() {
	#ifdef ENVMAP_TYPE_CUBE
		vec4 texColor = textureCube( envMap, backgroundRotation * vec3( flipEnvMap * vWorldDirection.x, vWorldDirection.yz ) );
	#elif defined( ENVMAP_TYPE_CUBE_UV )
		vec4 texColor = textureCubeUV( envMap, backgroundRotation * vWorldDirection, backgroundBlurriness );
	#else
		vec4 texColor = vec4( 0.0, 0.0, 0.0, 1.0 );
	#endif
	texColor.rgb *= backgroundIntensity;
	gl_FragColor = texColor;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,I1=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,U1=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,F1=`#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
varying vec2 vHighPrecisionZW;
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <skinbase_vertex>
	#include <morphinstance_vertex>
	#ifdef USE_DISPLACEMENTMAP
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vHighPrecisionZW = gl_Position.zw;
}`,O1=`#if DEPTH_PACKING == 3200
	uniform float opacity;
#endif
#include <common>
#include <packing>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
varying vec2 vHighPrecisionZW;
void main() {
	vec4 diffuseColor = vec4( 1.0 );
	#include <clipping_planes_fragment>
	#if DEPTH_PACKING == 3200
		diffuseColor.a = opacity;
	#endif
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <logdepthbuf_fragment>
	float fragCoordZ = 0.5 * vHighPrecisionZW[0] / vHighPrecisionZW[1] + 0.5;
	#if DEPTH_PACKING == 3200
		gl_FragColor = vec4( vec3( 1.0 - fragCoordZ ), opacity );
	#elif DEPTH_PACKING == 3201
		gl_FragColor = packDepthToRGBA( fragCoordZ );
	#elif DEPTH_PACKING == 3202
		gl_FragColor = vec4( packDepthToRGB( fragCoordZ ), 1.0 );
	#elif DEPTH_PACKING == 3203
		gl_FragColor = vec4( packDepthToRG( fragCoordZ ), 0.0, 1.0 );
	#endif
}`,k1=`#define DISTANCE
varying vec3 vWorldPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <skinbase_vertex>
	#include <morphinstance_vertex>
	#ifdef USE_DISPLACEMENTMAP
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <worldpos_vertex>
	#include <clipping_planes_vertex>
	vWorldPosition = worldPosition.xyz;
}`,B1=`#define DISTANCE
uniform vec3 referencePosition;
uniform float nearDistance;
uniform float farDistance;
varying vec3 vWorldPosition;
#include <common>
#include <packing>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <clipping_planes_pars_fragment>
void main () {
	vec4 diffuseColor = vec4( 1.0 );
	#include <clipping_planes_fragment>
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	float dist = length( vWorldPosition - referencePosition );
	dist = ( dist - nearDistance ) / ( farDistance - nearDistance );
	dist = saturate( dist );
	gl_FragColor = packDepthToRGBA( dist );
}`,z1=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,H1=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,V1=`uniform float scale;
attribute float lineDistance;
varying float vLineDistance;
#include <common>
#include <uv_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	vLineDistance = scale * lineDistance;
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
}`,G1=`uniform vec3 diffuse;
uniform float opacity;
uniform float dashSize;
uniform float totalSize;
varying float vLineDistance;
#include <common>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	if ( mod( vLineDistance, totalSize ) > dashSize ) {
		discard;
	}
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,W1=`#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#if defined ( USE_ENVMAP ) || defined ( USE_SKINNING )
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinbase_vertex>
		#include <skinnormal_vertex>
		#include <defaultnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <fog_vertex>
}`,$1=`uniform vec3 diffuse;
uniform float opacity;
#ifndef FLAT_SHADED
	varying vec3 vNormal;
#endif
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <fog_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	#ifdef USE_LIGHTMAP
		vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
		reflectedLight.indirectDiffuse += lightMapTexel.rgb * lightMapIntensity * RECIPROCAL_PI;
	#else
		reflectedLight.indirectDiffuse += vec3( 1.0 );
	#endif
	#include <aomap_fragment>
	reflectedLight.indirectDiffuse *= diffuseColor.rgb;
	vec3 outgoingLight = reflectedLight.indirectDiffuse;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,X1=`#define LAMBERT
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,q1=`#define LAMBERT
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <packing>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_lambert_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_lambert_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + totalEmissiveRadiance;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,Y1=`#define MATCAP
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <color_pars_vertex>
#include <displacementmap_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
	vViewPosition = - mvPosition.xyz;
}`,j1=`#define MATCAP
uniform vec3 diffuse;
uniform float opacity;
uniform sampler2D matcap;
varying vec3 vViewPosition;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <normal_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	vec3 viewDir = normalize( vViewPosition );
	vec3 x = normalize( vec3( viewDir.z, 0.0, - viewDir.x ) );
	vec3 y = cross( viewDir, x );
	vec2 uv = vec2( dot( x, normal ), dot( y, normal ) ) * 0.495 + 0.5;
	#ifdef USE_MATCAP
		vec4 matcapColor = texture2D( matcap, uv );
	#else
		vec4 matcapColor = vec4( vec3( mix( 0.2, 0.8, uv.y ) ), 1.0 );
	#endif
	vec3 outgoingLight = diffuseColor.rgb * matcapColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,K1=`#define NORMAL
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	varying vec3 vViewPosition;
#endif
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	vViewPosition = - mvPosition.xyz;
#endif
}`,Z1=`#define NORMAL
uniform float opacity;
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	varying vec3 vViewPosition;
#endif
#include <packing>
#include <uv_pars_fragment>
#include <normal_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( 0.0, 0.0, 0.0, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	gl_FragColor = vec4( packNormalToRGB( normal ), diffuseColor.a );
	#ifdef OPAQUE
		gl_FragColor.a = 1.0;
	#endif
}`,J1=`#define PHONG
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,Q1=`#define PHONG
uniform vec3 diffuse;
uniform vec3 emissive;
uniform vec3 specular;
uniform float shininess;
uniform float opacity;
#include <common>
#include <packing>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_phong_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_phong_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + reflectedLight.directSpecular + reflectedLight.indirectSpecular + totalEmissiveRadiance;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,eT=`#define STANDARD
varying vec3 vViewPosition;
#ifdef USE_TRANSMISSION
	varying vec3 vWorldPosition;
#endif
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
#ifdef USE_TRANSMISSION
	vWorldPosition = worldPosition.xyz;
#endif
}`,tT=`#define STANDARD
#ifdef PHYSICAL
	#define IOR
	#define USE_SPECULAR
#endif
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float roughness;
uniform float metalness;
uniform float opacity;
#ifdef IOR
	uniform float ior;
#endif
#ifdef USE_SPECULAR
	uniform float specularIntensity;
	uniform vec3 specularColor;
	#ifdef USE_SPECULAR_COLORMAP
		uniform sampler2D specularColorMap;
	#endif
	#ifdef USE_SPECULAR_INTENSITYMAP
		uniform sampler2D specularIntensityMap;
	#endif
#endif
#ifdef USE_CLEARCOAT
	uniform float clearcoat;
	uniform float clearcoatRoughness;
#endif
#ifdef USE_DISPERSION
	uniform float dispersion;
#endif
#ifdef USE_IRIDESCENCE
	uniform float iridescence;
	uniform float iridescenceIOR;
	uniform float iridescenceThicknessMinimum;
	uniform float iridescenceThicknessMaximum;
#endif
#ifdef USE_SHEEN
	uniform vec3 sheenColor;
	uniform float sheenRoughness;
	#ifdef USE_SHEEN_COLORMAP
		uniform sampler2D sheenColorMap;
	#endif
	#ifdef USE_SHEEN_ROUGHNESSMAP
		uniform sampler2D sheenRoughnessMap;
	#endif
#endif
#ifdef USE_ANISOTROPY
	uniform vec2 anisotropyVector;
	#ifdef USE_ANISOTROPYMAP
		uniform sampler2D anisotropyMap;
	#endif
#endif
varying vec3 vViewPosition;
#include <common>
#include <packing>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <iridescence_fragment>
#include <cube_uv_reflection_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_physical_pars_fragment>
#include <transmission_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <clearcoat_pars_fragment>
#include <iridescence_pars_fragment>
#include <roughnessmap_pars_fragment>
#include <metalnessmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <roughnessmap_fragment>
	#include <metalnessmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <clearcoat_normal_fragment_begin>
	#include <clearcoat_normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_physical_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 totalDiffuse = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse;
	vec3 totalSpecular = reflectedLight.directSpecular + reflectedLight.indirectSpecular;
	#include <transmission_fragment>
	vec3 outgoingLight = totalDiffuse + totalSpecular + totalEmissiveRadiance;
	#ifdef USE_SHEEN
		float sheenEnergyComp = 1.0 - 0.157 * max3( material.sheenColor );
		outgoingLight = outgoingLight * sheenEnergyComp + sheenSpecularDirect + sheenSpecularIndirect;
	#endif
	#ifdef USE_CLEARCOAT
		float dotNVcc = saturate( dot( geometryClearcoatNormal, geometryViewDir ) );
		vec3 Fcc = F_Schlick( material.clearcoatF0, material.clearcoatF90, dotNVcc );
		outgoingLight = outgoingLight * ( 1.0 - material.clearcoat * Fcc ) + ( clearcoatSpecularDirect + clearcoatSpecularIndirect ) * material.clearcoat;
	#endif
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,nT=`#define TOON
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,iT=`#define TOON
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <packing>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <gradientmap_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_toon_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_toon_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + totalEmissiveRadiance;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,sT=`uniform float size;
uniform float scale;
#include <common>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
#ifdef USE_POINTS_UV
	varying vec2 vUv;
	uniform mat3 uvTransform;
#endif
void main() {
	#ifdef USE_POINTS_UV
		vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	#endif
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <project_vertex>
	gl_PointSize = size;
	#ifdef USE_SIZEATTENUATION
		bool isPerspective = isPerspectiveMatrix( projectionMatrix );
		if ( isPerspective ) gl_PointSize *= ( scale / - mvPosition.z );
	#endif
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <worldpos_vertex>
	#include <fog_vertex>
}`,rT=`uniform vec3 diffuse;
uniform float opacity;
#include <common>
#include <color_pars_fragment>
#include <map_particle_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_particle_fragment>
	#include <color_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,oT=`#include <common>
#include <batching_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <shadowmap_pars_vertex>
void main() {
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,aT=`uniform vec3 color;
uniform float opacity;
#include <common>
#include <packing>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <logdepthbuf_pars_fragment>
#include <shadowmap_pars_fragment>
#include <shadowmask_pars_fragment>
void main() {
	#include <logdepthbuf_fragment>
	gl_FragColor = vec4( color, opacity * ( 1.0 - getShadowMask() ) );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
}`,lT=`uniform float rotation;
uniform vec2 center;
#include <common>
#include <uv_pars_vertex>
#include <fog_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	vec4 mvPosition = modelViewMatrix[ 3 ];
	vec2 scale = vec2( length( modelMatrix[ 0 ].xyz ), length( modelMatrix[ 1 ].xyz ) );
	#ifndef USE_SIZEATTENUATION
		bool isPerspective = isPerspectiveMatrix( projectionMatrix );
		if ( isPerspective ) scale *= - mvPosition.z;
	#endif
	vec2 alignedPosition = ( position.xy - ( center - vec2( 0.5 ) ) ) * scale;
	vec2 rotatedPosition;
	rotatedPosition.x = cos( rotation ) * alignedPosition.x - sin( rotation ) * alignedPosition.y;
	rotatedPosition.y = sin( rotation ) * alignedPosition.x + cos( rotation ) * alignedPosition.y;
	mvPosition.xy += rotatedPosition;
	gl_Position = projectionMatrix * mvPosition;
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
}`,cT=`uniform vec3 diffuse;
uniform float opacity;
#include <common>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
}`,nt={alphahash_fragment:LE,alphahash_pars_fragment:DE,alphamap_fragment:NE,alphamap_pars_fragment:IE,alphatest_fragment:UE,alphatest_pars_fragment:FE,aomap_fragment:OE,aomap_pars_fragment:kE,batching_pars_vertex:BE,batching_vertex:zE,begin_vertex:HE,beginnormal_vertex:VE,bsdfs:GE,iridescence_fragment:WE,bumpmap_pars_fragment:$E,clipping_planes_fragment:XE,clipping_planes_pars_fragment:qE,clipping_planes_pars_vertex:YE,clipping_planes_vertex:jE,color_fragment:KE,color_pars_fragment:ZE,color_pars_vertex:JE,color_vertex:QE,common:ew,cube_uv_reflection_fragment:tw,defaultnormal_vertex:nw,displacementmap_pars_vertex:iw,displacementmap_vertex:sw,emissivemap_fragment:rw,emissivemap_pars_fragment:ow,colorspace_fragment:aw,colorspace_pars_fragment:lw,envmap_fragment:cw,envmap_common_pars_fragment:uw,envmap_pars_fragment:hw,envmap_pars_vertex:dw,envmap_physical_pars_fragment:bw,envmap_vertex:fw,fog_vertex:pw,fog_pars_vertex:mw,fog_fragment:gw,fog_pars_fragment:_w,gradientmap_pars_fragment:vw,lightmap_pars_fragment:xw,lights_lambert_fragment:Mw,lights_lambert_pars_fragment:Sw,lights_pars_begin:yw,lights_toon_fragment:Ew,lights_toon_pars_fragment:ww,lights_phong_fragment:Tw,lights_phong_pars_fragment:Aw,lights_physical_fragment:Rw,lights_physical_pars_fragment:Cw,lights_fragment_begin:Pw,lights_fragment_maps:Lw,lights_fragment_end:Dw,logdepthbuf_fragment:Nw,logdepthbuf_pars_fragment:Iw,logdepthbuf_pars_vertex:Uw,logdepthbuf_vertex:Fw,map_fragment:Ow,map_pars_fragment:kw,map_particle_fragment:Bw,map_particle_pars_fragment:zw,metalnessmap_fragment:Hw,metalnessmap_pars_fragment:Vw,morphinstance_vertex:Gw,morphcolor_vertex:Ww,morphnormal_vertex:$w,morphtarget_pars_vertex:Xw,morphtarget_vertex:qw,normal_fragment_begin:Yw,normal_fragment_maps:jw,normal_pars_fragment:Kw,normal_pars_vertex:Zw,normal_vertex:Jw,normalmap_pars_fragment:Qw,clearcoat_normal_fragment_begin:e1,clearcoat_normal_fragment_maps:t1,clearcoat_pars_fragment:n1,iridescence_pars_fragment:i1,opaque_fragment:s1,packing:r1,premultiplied_alpha_fragment:o1,project_vertex:a1,dithering_fragment:l1,dithering_pars_fragment:c1,roughnessmap_fragment:u1,roughnessmap_pars_fragment:h1,shadowmap_pars_fragment:d1,shadowmap_pars_vertex:f1,shadowmap_vertex:p1,shadowmask_pars_fragment:m1,skinbase_vertex:g1,skinning_pars_vertex:_1,skinning_vertex:v1,skinnormal_vertex:x1,specularmap_fragment:M1,specularmap_pars_fragment:S1,tonemapping_fragment:y1,tonemapping_pars_fragment:b1,transmission_fragment:E1,transmission_pars_fragment:w1,uv_pars_fragment:T1,uv_pars_vertex:A1,uv_vertex:R1,worldpos_vertex:C1,background_vert:P1,background_frag:L1,backgroundCube_vert:D1,backgroundCube_frag:N1,cube_vert:I1,cube_frag:U1,depth_vert:F1,depth_frag:O1,distanceRGBA_vert:k1,distanceRGBA_frag:B1,equirect_vert:z1,equirect_frag:H1,linedashed_vert:V1,linedashed_frag:G1,meshbasic_vert:W1,meshbasic_frag:$1,meshlambert_vert:X1,meshlambert_frag:q1,meshmatcap_vert:Y1,meshmatcap_frag:j1,meshnormal_vert:K1,meshnormal_frag:Z1,meshphong_vert:J1,meshphong_frag:Q1,meshphysical_vert:eT,meshphysical_frag:tT,meshtoon_vert:nT,meshtoon_frag:iT,points_vert:sT,points_frag:rT,shadow_vert:oT,shadow_frag:aT,sprite_vert:lT,sprite_frag:cT},Te={common:{diffuse:{value:new at(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new et},alphaMap:{value:null},alphaMapTransform:{value:new et},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new et}},envmap:{envMap:{value:null},envMapRotation:{value:new et},flipEnvMap:{value:-1},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new et}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new et}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new et},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new et},normalScale:{value:new mt(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new et},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new et}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new et}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new et}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new at(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMap:{value:[]},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotShadowMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMap:{value:[]},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null}},points:{diffuse:{value:new at(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new et},alphaTest:{value:0},uvTransform:{value:new et}},sprite:{diffuse:{value:new at(16777215)},opacity:{value:1},center:{value:new mt(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new et},alphaMap:{value:null},alphaMapTransform:{value:new et},alphaTest:{value:0}}},gi={basic:{uniforms:Mn([Te.common,Te.specularmap,Te.envmap,Te.aomap,Te.lightmap,Te.fog]),vertexShader:nt.meshbasic_vert,fragmentShader:nt.meshbasic_frag},lambert:{uniforms:Mn([Te.common,Te.specularmap,Te.envmap,Te.aomap,Te.lightmap,Te.emissivemap,Te.bumpmap,Te.normalmap,Te.displacementmap,Te.fog,Te.lights,{emissive:{value:new at(0)}}]),vertexShader:nt.meshlambert_vert,fragmentShader:nt.meshlambert_frag},phong:{uniforms:Mn([Te.common,Te.specularmap,Te.envmap,Te.aomap,Te.lightmap,Te.emissivemap,Te.bumpmap,Te.normalmap,Te.displacementmap,Te.fog,Te.lights,{emissive:{value:new at(0)},specular:{value:new at(1118481)},shininess:{value:30}}]),vertexShader:nt.meshphong_vert,fragmentShader:nt.meshphong_frag},standard:{uniforms:Mn([Te.common,Te.envmap,Te.aomap,Te.lightmap,Te.emissivemap,Te.bumpmap,Te.normalmap,Te.displacementmap,Te.roughnessmap,Te.metalnessmap,Te.fog,Te.lights,{emissive:{value:new at(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:nt.meshphysical_vert,fragmentShader:nt.meshphysical_frag},toon:{uniforms:Mn([Te.common,Te.aomap,Te.lightmap,Te.emissivemap,Te.bumpmap,Te.normalmap,Te.displacementmap,Te.gradientmap,Te.fog,Te.lights,{emissive:{value:new at(0)}}]),vertexShader:nt.meshtoon_vert,fragmentShader:nt.meshtoon_frag},matcap:{uniforms:Mn([Te.common,Te.bumpmap,Te.normalmap,Te.displacementmap,Te.fog,{matcap:{value:null}}]),vertexShader:nt.meshmatcap_vert,fragmentShader:nt.meshmatcap_frag},points:{uniforms:Mn([Te.points,Te.fog]),vertexShader:nt.points_vert,fragmentShader:nt.points_frag},dashed:{uniforms:Mn([Te.common,Te.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:nt.linedashed_vert,fragmentShader:nt.linedashed_frag},depth:{uniforms:Mn([Te.common,Te.displacementmap]),vertexShader:nt.depth_vert,fragmentShader:nt.depth_frag},normal:{uniforms:Mn([Te.common,Te.bumpmap,Te.normalmap,Te.displacementmap,{opacity:{value:1}}]),vertexShader:nt.meshnormal_vert,fragmentShader:nt.meshnormal_frag},sprite:{uniforms:Mn([Te.sprite,Te.fog]),vertexShader:nt.sprite_vert,fragmentShader:nt.sprite_frag},background:{uniforms:{uvTransform:{value:new et},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:nt.background_vert,fragmentShader:nt.background_frag},backgroundCube:{uniforms:{envMap:{value:null},flipEnvMap:{value:-1},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new et}},vertexShader:nt.backgroundCube_vert,fragmentShader:nt.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:nt.cube_vert,fragmentShader:nt.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:nt.equirect_vert,fragmentShader:nt.equirect_frag},distanceRGBA:{uniforms:Mn([Te.common,Te.displacementmap,{referencePosition:{value:new Y},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:nt.distanceRGBA_vert,fragmentShader:nt.distanceRGBA_frag},shadow:{uniforms:Mn([Te.lights,Te.fog,{color:{value:new at(0)},opacity:{value:1}}]),vertexShader:nt.shadow_vert,fragmentShader:nt.shadow_frag}};gi.physical={uniforms:Mn([gi.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new et},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new et},clearcoatNormalScale:{value:new mt(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new et},dispersion:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new et},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new et},sheen:{value:0},sheenColor:{value:new at(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new et},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new et},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new et},transmissionSamplerSize:{value:new mt},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new et},attenuationDistance:{value:0},attenuationColor:{value:new at(0)},specularColor:{value:new at(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new et},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new et},anisotropyVector:{value:new mt},anisotropyMap:{value:null},anisotropyMapTransform:{value:new et}}]),vertexShader:nt.meshphysical_vert,fragmentShader:nt.meshphysical_frag};const ea={r:0,b:0,g:0},_s=new Si,uT=new Bt;function hT(i,e,t,n,s,r,o){const a=new at(0);let l=r===!0?0:1,c,u,h=null,d=0,m=null;function _(E){let T=E.isScene===!0?E.background:null;return T&&T.isTexture&&(T=(E.backgroundBlurriness>0?t:e).get(T)),T}function v(E){let T=!1;const M=_(E);M===null?f(a,l):M&&M.isColor&&(f(M,1),T=!0);const k=i.xr.getEnvironmentBlendMode();k==="additive"?n.buffers.color.setClear(0,0,0,1,o):k==="alpha-blend"&&n.buffers.color.setClear(0,0,0,0,o),(i.autoClear||T)&&(n.buffers.depth.setTest(!0),n.buffers.depth.setMask(!0),n.buffers.color.setMask(!0),i.clear(i.autoClearColor,i.autoClearDepth,i.autoClearStencil))}function p(E,T){const M=_(T);M&&(M.isCubeTexture||M.mapping===ka)?(u===void 0&&(u=new pn(new Os(1,1,1),new os({name:"BackgroundCubeMaterial",uniforms:Pr(gi.backgroundCube.uniforms),vertexShader:gi.backgroundCube.vertexShader,fragmentShader:gi.backgroundCube.fragmentShader,side:An,depthTest:!1,depthWrite:!1,fog:!1})),u.geometry.deleteAttribute("normal"),u.geometry.deleteAttribute("uv"),u.onBeforeRender=function(k,L,D){this.matrixWorld.copyPosition(D.matrixWorld)},Object.defineProperty(u.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),s.update(u)),_s.copy(T.backgroundRotation),_s.x*=-1,_s.y*=-1,_s.z*=-1,M.isCubeTexture&&M.isRenderTargetTexture===!1&&(_s.y*=-1,_s.z*=-1),u.material.uniforms.envMap.value=M,u.material.uniforms.flipEnvMap.value=M.isCubeTexture&&M.isRenderTargetTexture===!1?-1:1,u.material.uniforms.backgroundBlurriness.value=T.backgroundBlurriness,u.material.uniforms.backgroundIntensity.value=T.backgroundIntensity,u.material.uniforms.backgroundRotation.value.setFromMatrix4(uT.makeRotationFromEuler(_s)),u.material.toneMapped=pt.getTransfer(M.colorSpace)!==At,(h!==M||d!==M.version||m!==i.toneMapping)&&(u.material.needsUpdate=!0,h=M,d=M.version,m=i.toneMapping),u.layers.enableAll(),E.unshift(u,u.geometry,u.material,0,0,null)):M&&M.isTexture&&(c===void 0&&(c=new pn(new yo(2,2),new os({name:"BackgroundMaterial",uniforms:Pr(gi.background.uniforms),vertexShader:gi.background.vertexShader,fragmentShader:gi.background.fragmentShader,side:rs,depthTest:!1,depthWrite:!1,fog:!1})),c.geometry.deleteAttribute("normal"),Object.defineProperty(c.material,"map",{get:function(){return this.uniforms.t2D.value}}),s.update(c)),c.material.uniforms.t2D.value=M,c.material.uniforms.backgroundIntensity.value=T.backgroundIntensity,c.material.toneMapped=pt.getTransfer(M.colorSpace)!==At,M.matrixAutoUpdate===!0&&M.updateMatrix(),c.material.uniforms.uvTransform.value.copy(M.matrix),(h!==M||d!==M.version||m!==i.toneMapping)&&(c.material.needsUpdate=!0,h=M,d=M.version,m=i.toneMapping),c.layers.enableAll(),E.unshift(c,c.geometry,c.material,0,0,null))}function f(E,T){E.getRGB(ea,xp(i)),n.buffers.color.setClear(ea.r,ea.g,ea.b,T,o)}return{getClearColor:function(){return a},setClearColor:function(E,T=1){a.set(E),l=T,f(a,l)},getClearAlpha:function(){return l},setClearAlpha:function(E){l=E,f(a,l)},render:v,addToRenderList:p}}function dT(i,e){const t=i.getParameter(i.MAX_VERTEX_ATTRIBS),n={},s=d(null);let r=s,o=!1;function a(y,R,V,U,K){let X=!1;const Q=h(U,V,R);r!==Q&&(r=Q,c(r.object)),X=m(y,U,V,K),X&&_(y,U,V,K),K!==null&&e.update(K,i.ELEMENT_ARRAY_BUFFER),(X||o)&&(o=!1,M(y,R,V,U),K!==null&&i.bindBuffer(i.ELEMENT_ARRAY_BUFFER,e.get(K).buffer))}function l(){return i.createVertexArray()}function c(y){return i.bindVertexArray(y)}function u(y){return i.deleteVertexArray(y)}function h(y,R,V){const U=V.wireframe===!0;let K=n[y.id];K===void 0&&(K={},n[y.id]=K);let X=K[R.id];X===void 0&&(X={},K[R.id]=X);let Q=X[U];return Q===void 0&&(Q=d(l()),X[U]=Q),Q}function d(y){const R=[],V=[],U=[];for(let K=0;K<t;K++)R[K]=0,V[K]=0,U[K]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:R,enabledAttributes:V,attributeDivisors:U,object:y,attributes:{},index:null}}function m(y,R,V,U){const K=r.attributes,X=R.attributes;let Q=0;const J=V.getAttributes();for(const ne in J)if(J[ne].location>=0){const he=K[ne];let _e=X[ne];if(_e===void 0&&(ne==="instanceMatrix"&&y.instanceMatrix&&(_e=y.instanceMatrix),ne==="instanceColor"&&y.instanceColor&&(_e=y.instanceColor)),he===void 0||he.attribute!==_e||_e&&he.data!==_e.data)return!0;Q++}return r.attributesNum!==Q||r.index!==U}function _(y,R,V,U){const K={},X=R.attributes;let Q=0;const J=V.getAttributes();for(const ne in J)if(J[ne].location>=0){let he=X[ne];he===void 0&&(ne==="instanceMatrix"&&y.instanceMatrix&&(he=y.instanceMatrix),ne==="instanceColor"&&y.instanceColor&&(he=y.instanceColor));const _e={};_e.attribute=he,he&&he.data&&(_e.data=he.data),K[ne]=_e,Q++}r.attributes=K,r.attributesNum=Q,r.index=U}function v(){const y=r.newAttributes;for(let R=0,V=y.length;R<V;R++)y[R]=0}function p(y){f(y,0)}function f(y,R){const V=r.newAttributes,U=r.enabledAttributes,K=r.attributeDivisors;V[y]=1,U[y]===0&&(i.enableVertexAttribArray(y),U[y]=1),K[y]!==R&&(i.vertexAttribDivisor(y,R),K[y]=R)}function E(){const y=r.newAttributes,R=r.enabledAttributes;for(let V=0,U=R.length;V<U;V++)R[V]!==y[V]&&(i.disableVertexAttribArray(V),R[V]=0)}function T(y,R,V,U,K,X,Q){Q===!0?i.vertexAttribIPointer(y,R,V,K,X):i.vertexAttribPointer(y,R,V,U,K,X)}function M(y,R,V,U){v();const K=U.attributes,X=V.getAttributes(),Q=R.defaultAttributeValues;for(const J in X){const ne=X[J];if(ne.location>=0){let fe=K[J];if(fe===void 0&&(J==="instanceMatrix"&&y.instanceMatrix&&(fe=y.instanceMatrix),J==="instanceColor"&&y.instanceColor&&(fe=y.instanceColor)),fe!==void 0){const he=fe.normalized,_e=fe.itemSize,ye=e.get(fe);if(ye===void 0)continue;const ge=ye.buffer,re=ye.type,ce=ye.bytesPerElement,ve=re===i.INT||re===i.UNSIGNED_INT||fe.gpuType===hu;if(fe.isInterleavedBufferAttribute){const le=fe.data,He=le.stride,Ge=fe.offset;if(le.isInstancedInterleavedBuffer){for(let Fe=0;Fe<ne.locationSize;Fe++)f(ne.location+Fe,le.meshPerAttribute);y.isInstancedMesh!==!0&&U._maxInstanceCount===void 0&&(U._maxInstanceCount=le.meshPerAttribute*le.count)}else for(let Fe=0;Fe<ne.locationSize;Fe++)p(ne.location+Fe);i.bindBuffer(i.ARRAY_BUFFER,ge);for(let Fe=0;Fe<ne.locationSize;Fe++)T(ne.location+Fe,_e/ne.locationSize,re,he,He*ce,(Ge+_e/ne.locationSize*Fe)*ce,ve)}else{if(fe.isInstancedBufferAttribute){for(let le=0;le<ne.locationSize;le++)f(ne.location+le,fe.meshPerAttribute);y.isInstancedMesh!==!0&&U._maxInstanceCount===void 0&&(U._maxInstanceCount=fe.meshPerAttribute*fe.count)}else for(let le=0;le<ne.locationSize;le++)p(ne.location+le);i.bindBuffer(i.ARRAY_BUFFER,ge);for(let le=0;le<ne.locationSize;le++)T(ne.location+le,_e/ne.locationSize,re,he,_e*ce,_e/ne.locationSize*le*ce,ve)}}else if(Q!==void 0){const he=Q[J];if(he!==void 0)switch(he.length){case 2:i.vertexAttrib2fv(ne.location,he);break;case 3:i.vertexAttrib3fv(ne.location,he);break;case 4:i.vertexAttrib4fv(ne.location,he);break;default:i.vertexAttrib1fv(ne.location,he)}}}}E()}function k(){N();for(const y in n){const R=n[y];for(const V in R){const U=R[V];for(const K in U)u(U[K].object),delete U[K];delete R[V]}delete n[y]}}function L(y){if(n[y.id]===void 0)return;const R=n[y.id];for(const V in R){const U=R[V];for(const K in U)u(U[K].object),delete U[K];delete R[V]}delete n[y.id]}function D(y){for(const R in n){const V=n[R];if(V[y.id]===void 0)continue;const U=V[y.id];for(const K in U)u(U[K].object),delete U[K];delete V[y.id]}}function N(){w(),o=!0,r!==s&&(r=s,c(r.object))}function w(){s.geometry=null,s.program=null,s.wireframe=!1}return{setup:a,reset:N,resetDefaultState:w,dispose:k,releaseStatesOfGeometry:L,releaseStatesOfProgram:D,initAttributes:v,enableAttribute:p,disableUnusedAttributes:E}}function fT(i,e,t){let n;function s(c){n=c}function r(c,u){i.drawArrays(n,c,u),t.update(u,n,1)}function o(c,u,h){h!==0&&(i.drawArraysInstanced(n,c,u,h),t.update(u,n,h))}function a(c,u,h){if(h===0)return;e.get("WEBGL_multi_draw").multiDrawArraysWEBGL(n,c,0,u,0,h);let m=0;for(let _=0;_<h;_++)m+=u[_];t.update(m,n,1)}function l(c,u,h,d){if(h===0)return;const m=e.get("WEBGL_multi_draw");if(m===null)for(let _=0;_<c.length;_++)o(c[_],u[_],d[_]);else{m.multiDrawArraysInstancedWEBGL(n,c,0,u,0,d,0,h);let _=0;for(let v=0;v<h;v++)_+=u[v]*d[v];t.update(_,n,1)}}this.setMode=s,this.render=r,this.renderInstances=o,this.renderMultiDraw=a,this.renderMultiDrawInstances=l}function pT(i,e,t,n){let s;function r(){if(s!==void 0)return s;if(e.has("EXT_texture_filter_anisotropic")===!0){const D=e.get("EXT_texture_filter_anisotropic");s=i.getParameter(D.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else s=0;return s}function o(D){return!(D!==ri&&n.convert(D)!==i.getParameter(i.IMPLEMENTATION_COLOR_READ_FORMAT))}function a(D){const N=D===vo&&(e.has("EXT_color_buffer_half_float")||e.has("EXT_color_buffer_float"));return!(D!==Bi&&n.convert(D)!==i.getParameter(i.IMPLEMENTATION_COLOR_READ_TYPE)&&D!==Ii&&!N)}function l(D){if(D==="highp"){if(i.getShaderPrecisionFormat(i.VERTEX_SHADER,i.HIGH_FLOAT).precision>0&&i.getShaderPrecisionFormat(i.FRAGMENT_SHADER,i.HIGH_FLOAT).precision>0)return"highp";D="mediump"}return D==="mediump"&&i.getShaderPrecisionFormat(i.VERTEX_SHADER,i.MEDIUM_FLOAT).precision>0&&i.getShaderPrecisionFormat(i.FRAGMENT_SHADER,i.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let c=t.precision!==void 0?t.precision:"highp";const u=l(c);u!==c&&(console.warn("THREE.WebGLRenderer:",c,"not supported, using",u,"instead."),c=u);const h=t.logarithmicDepthBuffer===!0,d=t.reverseDepthBuffer===!0&&e.has("EXT_clip_control"),m=i.getParameter(i.MAX_TEXTURE_IMAGE_UNITS),_=i.getParameter(i.MAX_VERTEX_TEXTURE_IMAGE_UNITS),v=i.getParameter(i.MAX_TEXTURE_SIZE),p=i.getParameter(i.MAX_CUBE_MAP_TEXTURE_SIZE),f=i.getParameter(i.MAX_VERTEX_ATTRIBS),E=i.getParameter(i.MAX_VERTEX_UNIFORM_VECTORS),T=i.getParameter(i.MAX_VARYING_VECTORS),M=i.getParameter(i.MAX_FRAGMENT_UNIFORM_VECTORS),k=_>0,L=i.getParameter(i.MAX_SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:r,getMaxPrecision:l,textureFormatReadable:o,textureTypeReadable:a,precision:c,logarithmicDepthBuffer:h,reverseDepthBuffer:d,maxTextures:m,maxVertexTextures:_,maxTextureSize:v,maxCubemapSize:p,maxAttributes:f,maxVertexUniforms:E,maxVaryings:T,maxFragmentUniforms:M,vertexTextures:k,maxSamples:L}}function mT(i){const e=this;let t=null,n=0,s=!1,r=!1;const o=new Qi,a=new et,l={value:null,needsUpdate:!1};this.uniform=l,this.numPlanes=0,this.numIntersection=0,this.init=function(h,d){const m=h.length!==0||d||n!==0||s;return s=d,n=h.length,m},this.beginShadows=function(){r=!0,u(null)},this.endShadows=function(){r=!1},this.setGlobalState=function(h,d){t=u(h,d,0)},this.setState=function(h,d,m){const _=h.clippingPlanes,v=h.clipIntersection,p=h.clipShadows,f=i.get(h);if(!s||_===null||_.length===0||r&&!p)r?u(null):c();else{const E=r?0:n,T=E*4;let M=f.clippingState||null;l.value=M,M=u(_,d,T,m);for(let k=0;k!==T;++k)M[k]=t[k];f.clippingState=M,this.numIntersection=v?this.numPlanes:0,this.numPlanes+=E}};function c(){l.value!==t&&(l.value=t,l.needsUpdate=n>0),e.numPlanes=n,e.numIntersection=0}function u(h,d,m,_){const v=h!==null?h.length:0;let p=null;if(v!==0){if(p=l.value,_!==!0||p===null){const f=m+v*4,E=d.matrixWorldInverse;a.getNormalMatrix(E),(p===null||p.length<f)&&(p=new Float32Array(f));for(let T=0,M=m;T!==v;++T,M+=4)o.copy(h[T]).applyMatrix4(E,a),o.normal.toArray(p,M),p[M+3]=o.constant}l.value=p,l.needsUpdate=!0}return e.numPlanes=v,e.numIntersection=0,p}}function gT(i){let e=new WeakMap;function t(o,a){return a===hc?o.mapping=Tr:a===dc&&(o.mapping=Ar),o}function n(o){if(o&&o.isTexture){const a=o.mapping;if(a===hc||a===dc)if(e.has(o)){const l=e.get(o).texture;return t(l,o.mapping)}else{const l=o.image;if(l&&l.height>0){const c=new AE(l.height);return c.fromEquirectangularTexture(i,o),e.set(o,c),o.addEventListener("dispose",s),t(c.texture,o.mapping)}else return null}}return o}function s(o){const a=o.target;a.removeEventListener("dispose",s);const l=e.get(a);l!==void 0&&(e.delete(a),l.dispose())}function r(){e=new WeakMap}return{get:n,dispose:r}}class bp extends Mp{constructor(e=-1,t=1,n=1,s=-1,r=.1,o=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=e,this.right=t,this.top=n,this.bottom=s,this.near=r,this.far=o,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.left=e.left,this.right=e.right,this.top=e.top,this.bottom=e.bottom,this.near=e.near,this.far=e.far,this.zoom=e.zoom,this.view=e.view===null?null:Object.assign({},e.view),this}setViewOffset(e,t,n,s,r,o){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=n,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){const e=(this.right-this.left)/(2*this.zoom),t=(this.top-this.bottom)/(2*this.zoom),n=(this.right+this.left)/2,s=(this.top+this.bottom)/2;let r=n-e,o=n+e,a=s+t,l=s-t;if(this.view!==null&&this.view.enabled){const c=(this.right-this.left)/this.view.fullWidth/this.zoom,u=(this.top-this.bottom)/this.view.fullHeight/this.zoom;r+=c*this.view.offsetX,o=r+c*this.view.width,a-=u*this.view.offsetY,l=a-u*this.view.height}this.projectionMatrix.makeOrthographic(r,o,a,l,this.near,this.far,this.coordinateSystem),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){const t=super.toJSON(e);return t.object.zoom=this.zoom,t.object.left=this.left,t.object.right=this.right,t.object.top=this.top,t.object.bottom=this.bottom,t.object.near=this.near,t.object.far=this.far,this.view!==null&&(t.object.view=Object.assign({},this.view)),t}}const pr=4,pd=[.125,.215,.35,.446,.526,.582],Ts=20,Ll=new bp,md=new at;let Dl=null,Nl=0,Il=0,Ul=!1;const ys=(1+Math.sqrt(5))/2,hr=1/ys,gd=[new Y(-ys,hr,0),new Y(ys,hr,0),new Y(-hr,0,ys),new Y(hr,0,ys),new Y(0,ys,-hr),new Y(0,ys,hr),new Y(-1,1,-1),new Y(1,1,-1),new Y(-1,1,1),new Y(1,1,1)];class _d{constructor(e){this._renderer=e,this._pingPongRenderTarget=null,this._lodMax=0,this._cubeSize=0,this._lodPlanes=[],this._sizeLods=[],this._sigmas=[],this._blurMaterial=null,this._cubemapMaterial=null,this._equirectMaterial=null,this._compileMaterial(this._blurMaterial)}fromScene(e,t=0,n=.1,s=100){Dl=this._renderer.getRenderTarget(),Nl=this._renderer.getActiveCubeFace(),Il=this._renderer.getActiveMipmapLevel(),Ul=this._renderer.xr.enabled,this._renderer.xr.enabled=!1,this._setSize(256);const r=this._allocateTargets();return r.depthBuffer=!0,this._sceneToCubeUV(e,n,s,r),t>0&&this._blur(r,0,0,t),this._applyPMREM(r),this._cleanup(r),r}fromEquirectangular(e,t=null){return this._fromTexture(e,t)}fromCubemap(e,t=null){return this._fromTexture(e,t)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=Md(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=xd(),this._compileMaterial(this._equirectMaterial))}dispose(){this._dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose()}_setSize(e){this._lodMax=Math.floor(Math.log2(e)),this._cubeSize=Math.pow(2,this._lodMax)}_dispose(){this._blurMaterial!==null&&this._blurMaterial.dispose(),this._pingPongRenderTarget!==null&&this._pingPongRenderTarget.dispose();for(let e=0;e<this._lodPlanes.length;e++)this._lodPlanes[e].dispose()}_cleanup(e){this._renderer.setRenderTarget(Dl,Nl,Il),this._renderer.xr.enabled=Ul,e.scissorTest=!1,ta(e,0,0,e.width,e.height)}_fromTexture(e,t){e.mapping===Tr||e.mapping===Ar?this._setSize(e.image.length===0?16:e.image[0].width||e.image[0].image.width):this._setSize(e.image.width/4),Dl=this._renderer.getRenderTarget(),Nl=this._renderer.getActiveCubeFace(),Il=this._renderer.getActiveMipmapLevel(),Ul=this._renderer.xr.enabled,this._renderer.xr.enabled=!1;const n=t||this._allocateTargets();return this._textureToCubeUV(e,n),this._applyPMREM(n),this._cleanup(n),n}_allocateTargets(){const e=3*Math.max(this._cubeSize,112),t=4*this._cubeSize,n={magFilter:vi,minFilter:vi,generateMipmaps:!1,type:vo,format:ri,colorSpace:Ur,depthBuffer:!1},s=vd(e,t,n);if(this._pingPongRenderTarget===null||this._pingPongRenderTarget.width!==e||this._pingPongRenderTarget.height!==t){this._pingPongRenderTarget!==null&&this._dispose(),this._pingPongRenderTarget=vd(e,t,n);const{_lodMax:r}=this;({sizeLods:this._sizeLods,lodPlanes:this._lodPlanes,sigmas:this._sigmas}=_T(r)),this._blurMaterial=vT(r,e,t)}return s}_compileMaterial(e){const t=new pn(this._lodPlanes[0],e);this._renderer.compile(t,Ll)}_sceneToCubeUV(e,t,n,s){const a=new Xn(90,1,t,n),l=[1,-1,1,1,1,1],c=[1,1,1,-1,-1,-1],u=this._renderer,h=u.autoClear,d=u.toneMapping;u.getClearColor(md),u.toneMapping=is,u.autoClear=!1;const m=new xu({name:"PMREM.Background",side:An,depthWrite:!1,depthTest:!1}),_=new pn(new Os,m);let v=!1;const p=e.background;p?p.isColor&&(m.color.copy(p),e.background=null,v=!0):(m.color.copy(md),v=!0);for(let f=0;f<6;f++){const E=f%3;E===0?(a.up.set(0,l[f],0),a.lookAt(c[f],0,0)):E===1?(a.up.set(0,0,l[f]),a.lookAt(0,c[f],0)):(a.up.set(0,l[f],0),a.lookAt(0,0,c[f]));const T=this._cubeSize;ta(s,E*T,f>2?T:0,T,T),u.setRenderTarget(s),v&&u.render(_,a),u.render(e,a)}_.geometry.dispose(),_.material.dispose(),u.toneMapping=d,u.autoClear=h,e.background=p}_textureToCubeUV(e,t){const n=this._renderer,s=e.mapping===Tr||e.mapping===Ar;s?(this._cubemapMaterial===null&&(this._cubemapMaterial=Md()),this._cubemapMaterial.uniforms.flipEnvMap.value=e.isRenderTargetTexture===!1?-1:1):this._equirectMaterial===null&&(this._equirectMaterial=xd());const r=s?this._cubemapMaterial:this._equirectMaterial,o=new pn(this._lodPlanes[0],r),a=r.uniforms;a.envMap.value=e;const l=this._cubeSize;ta(t,0,0,3*l,2*l),n.setRenderTarget(t),n.render(o,Ll)}_applyPMREM(e){const t=this._renderer,n=t.autoClear;t.autoClear=!1;const s=this._lodPlanes.length;for(let r=1;r<s;r++){const o=Math.sqrt(this._sigmas[r]*this._sigmas[r]-this._sigmas[r-1]*this._sigmas[r-1]),a=gd[(s-r-1)%gd.length];this._blur(e,r-1,r,o,a)}t.autoClear=n}_blur(e,t,n,s,r){const o=this._pingPongRenderTarget;this._halfBlur(e,o,t,n,s,"latitudinal",r),this._halfBlur(o,e,n,n,s,"longitudinal",r)}_halfBlur(e,t,n,s,r,o,a){const l=this._renderer,c=this._blurMaterial;o!=="latitudinal"&&o!=="longitudinal"&&console.error("blur direction must be either latitudinal or longitudinal!");const u=3,h=new pn(this._lodPlanes[s],c),d=c.uniforms,m=this._sizeLods[n]-1,_=isFinite(r)?Math.PI/(2*m):2*Math.PI/(2*Ts-1),v=r/_,p=isFinite(r)?1+Math.floor(u*v):Ts;p>Ts&&console.warn(`sigmaRadians, ${r}, is too large and will clip, as it requested ${p} samples when the maximum is set to ${Ts}`);const f=[];let E=0;for(let D=0;D<Ts;++D){const N=D/v,w=Math.exp(-N*N/2);f.push(w),D===0?E+=w:D<p&&(E+=2*w)}for(let D=0;D<f.length;D++)f[D]=f[D]/E;d.envMap.value=e.texture,d.samples.value=p,d.weights.value=f,d.latitudinal.value=o==="latitudinal",a&&(d.poleAxis.value=a);const{_lodMax:T}=this;d.dTheta.value=_,d.mipInt.value=T-n;const M=this._sizeLods[s],k=3*M*(s>T-pr?s-T+pr:0),L=4*(this._cubeSize-M);ta(t,k,L,3*M,2*M),l.setRenderTarget(t),l.render(h,Ll)}}function _T(i){const e=[],t=[],n=[];let s=i;const r=i-pr+1+pd.length;for(let o=0;o<r;o++){const a=Math.pow(2,s);t.push(a);let l=1/a;o>i-pr?l=pd[o-i+pr-1]:o===0&&(l=0),n.push(l);const c=1/(a-2),u=-c,h=1+c,d=[u,u,h,u,h,h,u,u,h,h,u,h],m=6,_=6,v=3,p=2,f=1,E=new Float32Array(v*_*m),T=new Float32Array(p*_*m),M=new Float32Array(f*_*m);for(let L=0;L<m;L++){const D=L%3*2/3-1,N=L>2?0:-1,w=[D,N,0,D+2/3,N,0,D+2/3,N+1,0,D,N,0,D+2/3,N+1,0,D,N+1,0];E.set(w,v*_*L),T.set(d,p*_*L);const y=[L,L,L,L,L,L];M.set(y,f*_*L)}const k=new yi;k.setAttribute("position",new xi(E,v)),k.setAttribute("uv",new xi(T,p)),k.setAttribute("faceIndex",new xi(M,f)),e.push(k),s>pr&&s--}return{lodPlanes:e,sizeLods:t,sigmas:n}}function vd(i,e,t){const n=new Fs(i,e,t);return n.texture.mapping=ka,n.texture.name="PMREM.cubeUv",n.scissorTest=!0,n}function ta(i,e,t,n,s){i.viewport.set(e,t,n,s),i.scissor.set(e,t,n,s)}function vT(i,e,t){const n=new Float32Array(Ts),s=new Y(0,1,0);return new os({name:"SphericalGaussianBlur",defines:{n:Ts,CUBEUV_TEXEL_WIDTH:1/e,CUBEUV_TEXEL_HEIGHT:1/t,CUBEUV_MAX_MIP:`${i}.0`},uniforms:{envMap:{value:null},samples:{value:1},weights:{value:n},latitudinal:{value:!1},dTheta:{value:0},mipInt:{value:0},poleAxis:{value:s}},vertexShader:Su(),fragmentShader:`

			precision mediump float;
			precision mediump int;

			varying vec3 vOutputDirection;

			uniform sampler2D envMap;
			uniform int samples;
			uniform float weights[ n ];
			uniform bool latitudinal;
			uniform float dTheta;
			uniform float mipInt;
			uniform vec3 poleAxis;

			#define ENVMAP_TYPE_CUBE_UV
			#include <cube_uv_reflection_fragment>

			vec3 getSample( float theta, vec3 axis ) {

				float cosTheta = cos( theta );
				// Rodrigues' axis-angle rotation
				vec3 sampleDirection = vOutputDirection * cosTheta
					+ cross( axis, vOutputDirection ) * sin( theta )
					+ axis * dot( axis, vOutputDirection ) * ( 1.0 - cosTheta );

				return bilinearCubeUV( envMap, sampleDirection, mipInt );

			}

			void main() {

				vec3 axis = latitudinal ? poleAxis : cross( poleAxis, vOutputDirection );

				if ( all( equal( axis, vec3( 0.0 ) ) ) ) {

					axis = vec3( vOutputDirection.z, 0.0, - vOutputDirection.x );

				}

				axis = normalize( axis );

				gl_FragColor = vec4( 0.0, 0.0, 0.0, 1.0 );
				gl_FragColor.rgb += weights[ 0 ] * getSample( 0.0, axis );

				for ( int i = 1; i < n; i++ ) {

					if ( i >= samples ) {

						break;

					}

					float theta = dTheta * float( i );
					gl_FragColor.rgb += weights[ i ] * getSample( -1.0 * theta, axis );
					gl_FragColor.rgb += weights[ i ] * getSample( theta, axis );

				}

			}
		`,blending:ns,depthTest:!1,depthWrite:!1})}function xd(){return new os({name:"EquirectangularToCubeUV",uniforms:{envMap:{value:null}},vertexShader:Su(),fragmentShader:`

			precision mediump float;
			precision mediump int;

			varying vec3 vOutputDirection;

			uniform sampler2D envMap;

			#include <common>

			void main() {

				vec3 outputDirection = normalize( vOutputDirection );
				vec2 uv = equirectUv( outputDirection );

				gl_FragColor = vec4( texture2D ( envMap, uv ).rgb, 1.0 );

			}
		`,blending:ns,depthTest:!1,depthWrite:!1})}function Md(){return new os({name:"CubemapToCubeUV",uniforms:{envMap:{value:null},flipEnvMap:{value:-1}},vertexShader:Su(),fragmentShader:`

			precision mediump float;
			precision mediump int;

			uniform float flipEnvMap;

			varying vec3 vOutputDirection;

			uniform samplerCube envMap;

			void main() {

				gl_FragColor = textureCube( envMap, vec3( flipEnvMap * vOutputDirection.x, vOutputDirection.yz ) );

			}
		`,blending:ns,depthTest:!1,depthWrite:!1})}function Su(){return`

		precision mediump float;
		precision mediump int;

		attribute float faceIndex;

		varying vec3 vOutputDirection;

		// RH coordinate system; PMREM face-indexing convention
		vec3 getDirection( vec2 uv, float face ) {

			uv = 2.0 * uv - 1.0;

			vec3 direction = vec3( uv, 1.0 );

			if ( face == 0.0 ) {

				direction = direction.zyx; // ( 1, v, u ) pos x

			} else if ( face == 1.0 ) {

				direction = direction.xzy;
				direction.xz *= -1.0; // ( -u, 1, -v ) pos y

			} else if ( face == 2.0 ) {

				direction.x *= -1.0; // ( -u, v, 1 ) pos z

			} else if ( face == 3.0 ) {

				direction = direction.zyx;
				direction.xz *= -1.0; // ( -1, v, -u ) neg x

			} else if ( face == 4.0 ) {

				direction = direction.xzy;
				direction.xy *= -1.0; // ( -u, -1, v ) neg y

			} else if ( face == 5.0 ) {

				direction.z *= -1.0; // ( u, v, -1 ) neg z

			}

			return direction;

		}

		void main() {

			vOutputDirection = getDirection( uv, faceIndex );
			gl_Position = vec4( position, 1.0 );

		}
	`}function xT(i){let e=new WeakMap,t=null;function n(a){if(a&&a.isTexture){const l=a.mapping,c=l===hc||l===dc,u=l===Tr||l===Ar;if(c||u){let h=e.get(a);const d=h!==void 0?h.texture.pmremVersion:0;if(a.isRenderTargetTexture&&a.pmremVersion!==d)return t===null&&(t=new _d(i)),h=c?t.fromEquirectangular(a,h):t.fromCubemap(a,h),h.texture.pmremVersion=a.pmremVersion,e.set(a,h),h.texture;if(h!==void 0)return h.texture;{const m=a.image;return c&&m&&m.height>0||u&&m&&s(m)?(t===null&&(t=new _d(i)),h=c?t.fromEquirectangular(a):t.fromCubemap(a),h.texture.pmremVersion=a.pmremVersion,e.set(a,h),a.addEventListener("dispose",r),h.texture):null}}}return a}function s(a){let l=0;const c=6;for(let u=0;u<c;u++)a[u]!==void 0&&l++;return l===c}function r(a){const l=a.target;l.removeEventListener("dispose",r);const c=e.get(l);c!==void 0&&(e.delete(l),c.dispose())}function o(){e=new WeakMap,t!==null&&(t.dispose(),t=null)}return{get:n,dispose:o}}function MT(i){const e={};function t(n){if(e[n]!==void 0)return e[n];let s;switch(n){case"WEBGL_depth_texture":s=i.getExtension("WEBGL_depth_texture")||i.getExtension("MOZ_WEBGL_depth_texture")||i.getExtension("WEBKIT_WEBGL_depth_texture");break;case"EXT_texture_filter_anisotropic":s=i.getExtension("EXT_texture_filter_anisotropic")||i.getExtension("MOZ_EXT_texture_filter_anisotropic")||i.getExtension("WEBKIT_EXT_texture_filter_anisotropic");break;case"WEBGL_compressed_texture_s3tc":s=i.getExtension("WEBGL_compressed_texture_s3tc")||i.getExtension("MOZ_WEBGL_compressed_texture_s3tc")||i.getExtension("WEBKIT_WEBGL_compressed_texture_s3tc");break;case"WEBGL_compressed_texture_pvrtc":s=i.getExtension("WEBGL_compressed_texture_pvrtc")||i.getExtension("WEBKIT_WEBGL_compressed_texture_pvrtc");break;default:s=i.getExtension(n)}return e[n]=s,s}return{has:function(n){return t(n)!==null},init:function(){t("EXT_color_buffer_float"),t("WEBGL_clip_cull_distance"),t("OES_texture_float_linear"),t("EXT_color_buffer_half_float"),t("WEBGL_multisampled_render_to_texture"),t("WEBGL_render_shared_exponent")},get:function(n){const s=t(n);return s===null&&ro("THREE.WebGLRenderer: "+n+" extension not supported."),s}}}function ST(i,e,t,n){const s={},r=new WeakMap;function o(h){const d=h.target;d.index!==null&&e.remove(d.index);for(const _ in d.attributes)e.remove(d.attributes[_]);for(const _ in d.morphAttributes){const v=d.morphAttributes[_];for(let p=0,f=v.length;p<f;p++)e.remove(v[p])}d.removeEventListener("dispose",o),delete s[d.id];const m=r.get(d);m&&(e.remove(m),r.delete(d)),n.releaseStatesOfGeometry(d),d.isInstancedBufferGeometry===!0&&delete d._maxInstanceCount,t.memory.geometries--}function a(h,d){return s[d.id]===!0||(d.addEventListener("dispose",o),s[d.id]=!0,t.memory.geometries++),d}function l(h){const d=h.attributes;for(const _ in d)e.update(d[_],i.ARRAY_BUFFER);const m=h.morphAttributes;for(const _ in m){const v=m[_];for(let p=0,f=v.length;p<f;p++)e.update(v[p],i.ARRAY_BUFFER)}}function c(h){const d=[],m=h.index,_=h.attributes.position;let v=0;if(m!==null){const E=m.array;v=m.version;for(let T=0,M=E.length;T<M;T+=3){const k=E[T+0],L=E[T+1],D=E[T+2];d.push(k,L,L,D,D,k)}}else if(_!==void 0){const E=_.array;v=_.version;for(let T=0,M=E.length/3-1;T<M;T+=3){const k=T+0,L=T+1,D=T+2;d.push(k,L,L,D,D,k)}}else return;const p=new(fp(d)?vp:_p)(d,1);p.version=v;const f=r.get(h);f&&e.remove(f),r.set(h,p)}function u(h){const d=r.get(h);if(d){const m=h.index;m!==null&&d.version<m.version&&c(h)}else c(h);return r.get(h)}return{get:a,update:l,getWireframeAttribute:u}}function yT(i,e,t){let n;function s(d){n=d}let r,o;function a(d){r=d.type,o=d.bytesPerElement}function l(d,m){i.drawElements(n,m,r,d*o),t.update(m,n,1)}function c(d,m,_){_!==0&&(i.drawElementsInstanced(n,m,r,d*o,_),t.update(m,n,_))}function u(d,m,_){if(_===0)return;e.get("WEBGL_multi_draw").multiDrawElementsWEBGL(n,m,0,r,d,0,_);let p=0;for(let f=0;f<_;f++)p+=m[f];t.update(p,n,1)}function h(d,m,_,v){if(_===0)return;const p=e.get("WEBGL_multi_draw");if(p===null)for(let f=0;f<d.length;f++)c(d[f]/o,m[f],v[f]);else{p.multiDrawElementsInstancedWEBGL(n,m,0,r,d,0,v,0,_);let f=0;for(let E=0;E<_;E++)f+=m[E]*v[E];t.update(f,n,1)}}this.setMode=s,this.setIndex=a,this.render=l,this.renderInstances=c,this.renderMultiDraw=u,this.renderMultiDrawInstances=h}function bT(i){const e={geometries:0,textures:0},t={frame:0,calls:0,triangles:0,points:0,lines:0};function n(r,o,a){switch(t.calls++,o){case i.TRIANGLES:t.triangles+=a*(r/3);break;case i.LINES:t.lines+=a*(r/2);break;case i.LINE_STRIP:t.lines+=a*(r-1);break;case i.LINE_LOOP:t.lines+=a*r;break;case i.POINTS:t.points+=a*r;break;default:console.error("THREE.WebGLInfo: Unknown draw mode:",o);break}}function s(){t.calls=0,t.triangles=0,t.points=0,t.lines=0}return{memory:e,render:t,programs:null,autoReset:!0,reset:s,update:n}}function ET(i,e,t){const n=new WeakMap,s=new Gt;function r(o,a,l){const c=o.morphTargetInfluences,u=a.morphAttributes.position||a.morphAttributes.normal||a.morphAttributes.color,h=u!==void 0?u.length:0;let d=n.get(a);if(d===void 0||d.count!==h){let y=function(){N.dispose(),n.delete(a),a.removeEventListener("dispose",y)};var m=y;d!==void 0&&d.texture.dispose();const _=a.morphAttributes.position!==void 0,v=a.morphAttributes.normal!==void 0,p=a.morphAttributes.color!==void 0,f=a.morphAttributes.position||[],E=a.morphAttributes.normal||[],T=a.morphAttributes.color||[];let M=0;_===!0&&(M=1),v===!0&&(M=2),p===!0&&(M=3);let k=a.attributes.position.count*M,L=1;k>e.maxTextureSize&&(L=Math.ceil(k/e.maxTextureSize),k=e.maxTextureSize);const D=new Float32Array(k*L*4*h),N=new mp(D,k,L,h);N.type=Ii,N.needsUpdate=!0;const w=M*4;for(let R=0;R<h;R++){const V=f[R],U=E[R],K=T[R],X=k*L*4*R;for(let Q=0;Q<V.count;Q++){const J=Q*w;_===!0&&(s.fromBufferAttribute(V,Q),D[X+J+0]=s.x,D[X+J+1]=s.y,D[X+J+2]=s.z,D[X+J+3]=0),v===!0&&(s.fromBufferAttribute(U,Q),D[X+J+4]=s.x,D[X+J+5]=s.y,D[X+J+6]=s.z,D[X+J+7]=0),p===!0&&(s.fromBufferAttribute(K,Q),D[X+J+8]=s.x,D[X+J+9]=s.y,D[X+J+10]=s.z,D[X+J+11]=K.itemSize===4?s.w:1)}}d={count:h,texture:N,size:new mt(k,L)},n.set(a,d),a.addEventListener("dispose",y)}if(o.isInstancedMesh===!0&&o.morphTexture!==null)l.getUniforms().setValue(i,"morphTexture",o.morphTexture,t);else{let _=0;for(let p=0;p<c.length;p++)_+=c[p];const v=a.morphTargetsRelative?1:1-_;l.getUniforms().setValue(i,"morphTargetBaseInfluence",v),l.getUniforms().setValue(i,"morphTargetInfluences",c)}l.getUniforms().setValue(i,"morphTargetsTexture",d.texture,t),l.getUniforms().setValue(i,"morphTargetsTextureSize",d.size)}return{update:r}}function wT(i,e,t,n){let s=new WeakMap;function r(l){const c=n.render.frame,u=l.geometry,h=e.get(l,u);if(s.get(h)!==c&&(e.update(h),s.set(h,c)),l.isInstancedMesh&&(l.hasEventListener("dispose",a)===!1&&l.addEventListener("dispose",a),s.get(l)!==c&&(t.update(l.instanceMatrix,i.ARRAY_BUFFER),l.instanceColor!==null&&t.update(l.instanceColor,i.ARRAY_BUFFER),s.set(l,c))),l.isSkinnedMesh){const d=l.skeleton;s.get(d)!==c&&(d.update(),s.set(d,c))}return h}function o(){s=new WeakMap}function a(l){const c=l.target;c.removeEventListener("dispose",a),t.remove(c.instanceMatrix),c.instanceColor!==null&&t.remove(c.instanceColor)}return{update:r,dispose:o}}class Ep extends yn{constructor(e,t,n,s,r,o,a,l,c,u=_r){if(u!==_r&&u!==Cr)throw new Error("DepthTexture format must be either THREE.DepthFormat or THREE.DepthStencilFormat");n===void 0&&u===_r&&(n=Us),n===void 0&&u===Cr&&(n=Rr),super(null,s,r,o,a,l,u,n,c),this.isDepthTexture=!0,this.image={width:e,height:t},this.magFilter=a!==void 0?a:oi,this.minFilter=l!==void 0?l:oi,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(e){return super.copy(e),this.compareFunction=e.compareFunction,this}toJSON(e){const t=super.toJSON(e);return this.compareFunction!==null&&(t.compareFunction=this.compareFunction),t}}const wp=new yn,Sd=new Ep(1,1),Tp=new mp,Ap=new hE,Rp=new Sp,yd=[],bd=[],Ed=new Float32Array(16),wd=new Float32Array(9),Td=new Float32Array(4);function kr(i,e,t){const n=i[0];if(n<=0||n>0)return i;const s=e*t;let r=yd[s];if(r===void 0&&(r=new Float32Array(s),yd[s]=r),e!==0){n.toArray(r,0);for(let o=1,a=0;o!==e;++o)a+=t,i[o].toArray(r,a)}return r}function Qt(i,e){if(i.length!==e.length)return!1;for(let t=0,n=i.length;t<n;t++)if(i[t]!==e[t])return!1;return!0}function en(i,e){for(let t=0,n=e.length;t<n;t++)i[t]=e[t]}function Ha(i,e){let t=bd[e];t===void 0&&(t=new Int32Array(e),bd[e]=t);for(let n=0;n!==e;++n)t[n]=i.allocateTextureUnit();return t}function TT(i,e){const t=this.cache;t[0]!==e&&(i.uniform1f(this.addr,e),t[0]=e)}function AT(i,e){const t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(i.uniform2f(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(Qt(t,e))return;i.uniform2fv(this.addr,e),en(t,e)}}function RT(i,e){const t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(i.uniform3f(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else if(e.r!==void 0)(t[0]!==e.r||t[1]!==e.g||t[2]!==e.b)&&(i.uniform3f(this.addr,e.r,e.g,e.b),t[0]=e.r,t[1]=e.g,t[2]=e.b);else{if(Qt(t,e))return;i.uniform3fv(this.addr,e),en(t,e)}}function CT(i,e){const t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(i.uniform4f(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(Qt(t,e))return;i.uniform4fv(this.addr,e),en(t,e)}}function PT(i,e){const t=this.cache,n=e.elements;if(n===void 0){if(Qt(t,e))return;i.uniformMatrix2fv(this.addr,!1,e),en(t,e)}else{if(Qt(t,n))return;Td.set(n),i.uniformMatrix2fv(this.addr,!1,Td),en(t,n)}}function LT(i,e){const t=this.cache,n=e.elements;if(n===void 0){if(Qt(t,e))return;i.uniformMatrix3fv(this.addr,!1,e),en(t,e)}else{if(Qt(t,n))return;wd.set(n),i.uniformMatrix3fv(this.addr,!1,wd),en(t,n)}}function DT(i,e){const t=this.cache,n=e.elements;if(n===void 0){if(Qt(t,e))return;i.uniformMatrix4fv(this.addr,!1,e),en(t,e)}else{if(Qt(t,n))return;Ed.set(n),i.uniformMatrix4fv(this.addr,!1,Ed),en(t,n)}}function NT(i,e){const t=this.cache;t[0]!==e&&(i.uniform1i(this.addr,e),t[0]=e)}function IT(i,e){const t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(i.uniform2i(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(Qt(t,e))return;i.uniform2iv(this.addr,e),en(t,e)}}function UT(i,e){const t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(i.uniform3i(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(Qt(t,e))return;i.uniform3iv(this.addr,e),en(t,e)}}function FT(i,e){const t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(i.uniform4i(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(Qt(t,e))return;i.uniform4iv(this.addr,e),en(t,e)}}function OT(i,e){const t=this.cache;t[0]!==e&&(i.uniform1ui(this.addr,e),t[0]=e)}function kT(i,e){const t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(i.uniform2ui(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(Qt(t,e))return;i.uniform2uiv(this.addr,e),en(t,e)}}function BT(i,e){const t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(i.uniform3ui(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(Qt(t,e))return;i.uniform3uiv(this.addr,e),en(t,e)}}function zT(i,e){const t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(i.uniform4ui(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(Qt(t,e))return;i.uniform4uiv(this.addr,e),en(t,e)}}function HT(i,e,t){const n=this.cache,s=t.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s);let r;this.type===i.SAMPLER_2D_SHADOW?(Sd.compareFunction=dp,r=Sd):r=wp,t.setTexture2D(e||r,s)}function VT(i,e,t){const n=this.cache,s=t.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),t.setTexture3D(e||Ap,s)}function GT(i,e,t){const n=this.cache,s=t.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),t.setTextureCube(e||Rp,s)}function WT(i,e,t){const n=this.cache,s=t.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),t.setTexture2DArray(e||Tp,s)}function $T(i){switch(i){case 5126:return TT;case 35664:return AT;case 35665:return RT;case 35666:return CT;case 35674:return PT;case 35675:return LT;case 35676:return DT;case 5124:case 35670:return NT;case 35667:case 35671:return IT;case 35668:case 35672:return UT;case 35669:case 35673:return FT;case 5125:return OT;case 36294:return kT;case 36295:return BT;case 36296:return zT;case 35678:case 36198:case 36298:case 36306:case 35682:return HT;case 35679:case 36299:case 36307:return VT;case 35680:case 36300:case 36308:case 36293:return GT;case 36289:case 36303:case 36311:case 36292:return WT}}function XT(i,e){i.uniform1fv(this.addr,e)}function qT(i,e){const t=kr(e,this.size,2);i.uniform2fv(this.addr,t)}function YT(i,e){const t=kr(e,this.size,3);i.uniform3fv(this.addr,t)}function jT(i,e){const t=kr(e,this.size,4);i.uniform4fv(this.addr,t)}function KT(i,e){const t=kr(e,this.size,4);i.uniformMatrix2fv(this.addr,!1,t)}function ZT(i,e){const t=kr(e,this.size,9);i.uniformMatrix3fv(this.addr,!1,t)}function JT(i,e){const t=kr(e,this.size,16);i.uniformMatrix4fv(this.addr,!1,t)}function QT(i,e){i.uniform1iv(this.addr,e)}function eA(i,e){i.uniform2iv(this.addr,e)}function tA(i,e){i.uniform3iv(this.addr,e)}function nA(i,e){i.uniform4iv(this.addr,e)}function iA(i,e){i.uniform1uiv(this.addr,e)}function sA(i,e){i.uniform2uiv(this.addr,e)}function rA(i,e){i.uniform3uiv(this.addr,e)}function oA(i,e){i.uniform4uiv(this.addr,e)}function aA(i,e,t){const n=this.cache,s=e.length,r=Ha(t,s);Qt(n,r)||(i.uniform1iv(this.addr,r),en(n,r));for(let o=0;o!==s;++o)t.setTexture2D(e[o]||wp,r[o])}function lA(i,e,t){const n=this.cache,s=e.length,r=Ha(t,s);Qt(n,r)||(i.uniform1iv(this.addr,r),en(n,r));for(let o=0;o!==s;++o)t.setTexture3D(e[o]||Ap,r[o])}function cA(i,e,t){const n=this.cache,s=e.length,r=Ha(t,s);Qt(n,r)||(i.uniform1iv(this.addr,r),en(n,r));for(let o=0;o!==s;++o)t.setTextureCube(e[o]||Rp,r[o])}function uA(i,e,t){const n=this.cache,s=e.length,r=Ha(t,s);Qt(n,r)||(i.uniform1iv(this.addr,r),en(n,r));for(let o=0;o!==s;++o)t.setTexture2DArray(e[o]||Tp,r[o])}function hA(i){switch(i){case 5126:return XT;case 35664:return qT;case 35665:return YT;case 35666:return jT;case 35674:return KT;case 35675:return ZT;case 35676:return JT;case 5124:case 35670:return QT;case 35667:case 35671:return eA;case 35668:case 35672:return tA;case 35669:case 35673:return nA;case 5125:return iA;case 36294:return sA;case 36295:return rA;case 36296:return oA;case 35678:case 36198:case 36298:case 36306:case 35682:return aA;case 35679:case 36299:case 36307:return lA;case 35680:case 36300:case 36308:case 36293:return cA;case 36289:case 36303:case 36311:case 36292:return uA}}class dA{constructor(e,t,n){this.id=e,this.addr=n,this.cache=[],this.type=t.type,this.setValue=$T(t.type)}}class fA{constructor(e,t,n){this.id=e,this.addr=n,this.cache=[],this.type=t.type,this.size=t.size,this.setValue=hA(t.type)}}class pA{constructor(e){this.id=e,this.seq=[],this.map={}}setValue(e,t,n){const s=this.seq;for(let r=0,o=s.length;r!==o;++r){const a=s[r];a.setValue(e,t[a.id],n)}}}const Fl=/(\w+)(\])?(\[|\.)?/g;function Ad(i,e){i.seq.push(e),i.map[e.id]=e}function mA(i,e,t){const n=i.name,s=n.length;for(Fl.lastIndex=0;;){const r=Fl.exec(n),o=Fl.lastIndex;let a=r[1];const l=r[2]==="]",c=r[3];if(l&&(a=a|0),c===void 0||c==="["&&o+2===s){Ad(t,c===void 0?new dA(a,i,e):new fA(a,i,e));break}else{let h=t.map[a];h===void 0&&(h=new pA(a),Ad(t,h)),t=h}}}class pa{constructor(e,t){this.seq=[],this.map={};const n=e.getProgramParameter(t,e.ACTIVE_UNIFORMS);for(let s=0;s<n;++s){const r=e.getActiveUniform(t,s),o=e.getUniformLocation(t,r.name);mA(r,o,this)}}setValue(e,t,n,s){const r=this.map[t];r!==void 0&&r.setValue(e,n,s)}setOptional(e,t,n){const s=t[n];s!==void 0&&this.setValue(e,n,s)}static upload(e,t,n,s){for(let r=0,o=t.length;r!==o;++r){const a=t[r],l=n[a.id];l.needsUpdate!==!1&&a.setValue(e,l.value,s)}}static seqWithValue(e,t){const n=[];for(let s=0,r=e.length;s!==r;++s){const o=e[s];o.id in t&&n.push(o)}return n}}function Rd(i,e,t){const n=i.createShader(e);return i.shaderSource(n,t),i.compileShader(n),n}const gA=37297;let _A=0;function vA(i,e){const t=i.split(`
`),n=[],s=Math.max(e-6,0),r=Math.min(e+6,t.length);for(let o=s;o<r;o++){const a=o+1;n.push(`${a===e?">":" "} ${a}: ${t[o]}`)}return n.join(`
`)}const Cd=new et;function xA(i){pt._getMatrix(Cd,pt.workingColorSpace,i);const e=`mat3( ${Cd.elements.map(t=>t.toFixed(4))} )`;switch(pt.getTransfer(i)){case Ba:return[e,"LinearTransferOETF"];case At:return[e,"sRGBTransferOETF"];default:return console.warn("THREE.WebGLProgram: Unsupported color space: ",i),[e,"LinearTransferOETF"]}}function Pd(i,e,t){const n=i.getShaderParameter(e,i.COMPILE_STATUS),s=i.getShaderInfoLog(e).trim();if(n&&s==="")return"";const r=/ERROR: 0:(\d+)/.exec(s);if(r){const o=parseInt(r[1]);return t.toUpperCase()+`

`+s+`

`+vA(i.getShaderSource(e),o)}else return s}function MA(i,e){const t=xA(e);return[`vec4 ${i}( vec4 value ) {`,`	return ${t[1]}( vec4( value.rgb * ${t[0]}, value.a ) );`,"}"].join(`
`)}function SA(i,e){let t;switch(e){case kb:t="Linear";break;case Bb:t="Reinhard";break;case zb:t="Cineon";break;case Hb:t="ACESFilmic";break;case Gb:t="AgX";break;case Wb:t="Neutral";break;case Vb:t="Custom";break;default:console.warn("THREE.WebGLProgram: Unsupported toneMapping:",e),t="Linear"}return"vec3 "+i+"( vec3 color ) { return "+t+"ToneMapping( color ); }"}const na=new Y;function yA(){pt.getLuminanceCoefficients(na);const i=na.x.toFixed(4),e=na.y.toFixed(4),t=na.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${i}, ${e}, ${t} );`,"	return dot( weights, rgb );","}"].join(`
`)}function bA(i){return[i.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",i.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(oo).join(`
`)}function EA(i){const e=[];for(const t in i){const n=i[t];n!==!1&&e.push("#define "+t+" "+n)}return e.join(`
`)}function wA(i,e){const t={},n=i.getProgramParameter(e,i.ACTIVE_ATTRIBUTES);for(let s=0;s<n;s++){const r=i.getActiveAttrib(e,s),o=r.name;let a=1;r.type===i.FLOAT_MAT2&&(a=2),r.type===i.FLOAT_MAT3&&(a=3),r.type===i.FLOAT_MAT4&&(a=4),t[o]={type:r.type,location:i.getAttribLocation(e,o),locationSize:a}}return t}function oo(i){return i!==""}function Ld(i,e){const t=e.numSpotLightShadows+e.numSpotLightMaps-e.numSpotLightShadowsWithMaps;return i.replace(/NUM_DIR_LIGHTS/g,e.numDirLights).replace(/NUM_SPOT_LIGHTS/g,e.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,e.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,t).replace(/NUM_RECT_AREA_LIGHTS/g,e.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,e.numPointLights).replace(/NUM_HEMI_LIGHTS/g,e.numHemiLights).replace(/NUM_DIR_LIGHT_SHADOWS/g,e.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,e.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,e.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,e.numPointLightShadows)}function Dd(i,e){return i.replace(/NUM_CLIPPING_PLANES/g,e.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,e.numClippingPlanes-e.numClipIntersection)}const TA=/^[ \t]*#include +<([\w\d./]+)>/gm;function Hc(i){return i.replace(TA,RA)}const AA=new Map;function RA(i,e){let t=nt[e];if(t===void 0){const n=AA.get(e);if(n!==void 0)t=nt[n],console.warn('THREE.WebGLRenderer: Shader chunk "%s" has been deprecated. Use "%s" instead.',e,n);else throw new Error("Can not resolve #include <"+e+">")}return Hc(t)}const CA=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function Nd(i){return i.replace(CA,PA)}function PA(i,e,t,n){let s="";for(let r=parseInt(e);r<parseInt(t);r++)s+=n.replace(/\[\s*i\s*\]/g,"[ "+r+" ]").replace(/UNROLLED_LOOP_INDEX/g,r);return s}function Id(i){let e=`precision ${i.precision} float;
	precision ${i.precision} int;
	precision ${i.precision} sampler2D;
	precision ${i.precision} samplerCube;
	precision ${i.precision} sampler3D;
	precision ${i.precision} sampler2DArray;
	precision ${i.precision} sampler2DShadow;
	precision ${i.precision} samplerCubeShadow;
	precision ${i.precision} sampler2DArrayShadow;
	precision ${i.precision} isampler2D;
	precision ${i.precision} isampler3D;
	precision ${i.precision} isamplerCube;
	precision ${i.precision} isampler2DArray;
	precision ${i.precision} usampler2D;
	precision ${i.precision} usampler3D;
	precision ${i.precision} usamplerCube;
	precision ${i.precision} usampler2DArray;
	`;return i.precision==="highp"?e+=`
#define HIGH_PRECISION`:i.precision==="mediump"?e+=`
#define MEDIUM_PRECISION`:i.precision==="lowp"&&(e+=`
#define LOW_PRECISION`),e}function LA(i){let e="SHADOWMAP_TYPE_BASIC";return i.shadowMapType===Zf?e="SHADOWMAP_TYPE_PCF":i.shadowMapType===Jf?e="SHADOWMAP_TYPE_PCF_SOFT":i.shadowMapType===Di&&(e="SHADOWMAP_TYPE_VSM"),e}function DA(i){let e="ENVMAP_TYPE_CUBE";if(i.envMap)switch(i.envMapMode){case Tr:case Ar:e="ENVMAP_TYPE_CUBE";break;case ka:e="ENVMAP_TYPE_CUBE_UV";break}return e}function NA(i){let e="ENVMAP_MODE_REFLECTION";if(i.envMap)switch(i.envMapMode){case Ar:e="ENVMAP_MODE_REFRACTION";break}return e}function IA(i){let e="ENVMAP_BLENDING_NONE";if(i.envMap)switch(i.combine){case Qf:e="ENVMAP_BLENDING_MULTIPLY";break;case Fb:e="ENVMAP_BLENDING_MIX";break;case Ob:e="ENVMAP_BLENDING_ADD";break}return e}function UA(i){const e=i.envMapCubeUVHeight;if(e===null)return null;const t=Math.log2(e)-2,n=1/e;return{texelWidth:1/(3*Math.max(Math.pow(2,t),112)),texelHeight:n,maxMip:t}}function FA(i,e,t,n){const s=i.getContext(),r=t.defines;let o=t.vertexShader,a=t.fragmentShader;const l=LA(t),c=DA(t),u=NA(t),h=IA(t),d=UA(t),m=bA(t),_=EA(r),v=s.createProgram();let p,f,E=t.glslVersion?"#version "+t.glslVersion+`
`:"";t.isRawShaderMaterial?(p=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,_].filter(oo).join(`
`),p.length>0&&(p+=`
`),f=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,_].filter(oo).join(`
`),f.length>0&&(f+=`
`)):(p=[Id(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,_,t.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",t.batching?"#define USE_BATCHING":"",t.batchingColor?"#define USE_BATCHING_COLOR":"",t.instancing?"#define USE_INSTANCING":"",t.instancingColor?"#define USE_INSTANCING_COLOR":"",t.instancingMorph?"#define USE_INSTANCING_MORPH":"",t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.map?"#define USE_MAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+u:"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.displacementMap?"#define USE_DISPLACEMENTMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.mapUv?"#define MAP_UV "+t.mapUv:"",t.alphaMapUv?"#define ALPHAMAP_UV "+t.alphaMapUv:"",t.lightMapUv?"#define LIGHTMAP_UV "+t.lightMapUv:"",t.aoMapUv?"#define AOMAP_UV "+t.aoMapUv:"",t.emissiveMapUv?"#define EMISSIVEMAP_UV "+t.emissiveMapUv:"",t.bumpMapUv?"#define BUMPMAP_UV "+t.bumpMapUv:"",t.normalMapUv?"#define NORMALMAP_UV "+t.normalMapUv:"",t.displacementMapUv?"#define DISPLACEMENTMAP_UV "+t.displacementMapUv:"",t.metalnessMapUv?"#define METALNESSMAP_UV "+t.metalnessMapUv:"",t.roughnessMapUv?"#define ROUGHNESSMAP_UV "+t.roughnessMapUv:"",t.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+t.anisotropyMapUv:"",t.clearcoatMapUv?"#define CLEARCOATMAP_UV "+t.clearcoatMapUv:"",t.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+t.clearcoatNormalMapUv:"",t.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+t.clearcoatRoughnessMapUv:"",t.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+t.iridescenceMapUv:"",t.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+t.iridescenceThicknessMapUv:"",t.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+t.sheenColorMapUv:"",t.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+t.sheenRoughnessMapUv:"",t.specularMapUv?"#define SPECULARMAP_UV "+t.specularMapUv:"",t.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+t.specularColorMapUv:"",t.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+t.specularIntensityMapUv:"",t.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+t.transmissionMapUv:"",t.thicknessMapUv?"#define THICKNESSMAP_UV "+t.thicknessMapUv:"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexColors?"#define USE_COLOR":"",t.vertexAlphas?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.flatShading?"#define FLAT_SHADED":"",t.skinning?"#define USE_SKINNING":"",t.morphTargets?"#define USE_MORPHTARGETS":"",t.morphNormals&&t.flatShading===!1?"#define USE_MORPHNORMALS":"",t.morphColors?"#define USE_MORPHCOLORS":"",t.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+t.morphTextureStride:"",t.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+t.morphTargetsCount:"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+l:"",t.sizeAttenuation?"#define USE_SIZEATTENUATION":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.logarithmicDepthBuffer?"#define USE_LOGDEPTHBUF":"",t.reverseDepthBuffer?"#define USE_REVERSEDEPTHBUF":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(oo).join(`
`),f=[Id(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,_,t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",t.map?"#define USE_MAP":"",t.matcap?"#define USE_MATCAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+c:"",t.envMap?"#define "+u:"",t.envMap?"#define "+h:"",d?"#define CUBEUV_TEXEL_WIDTH "+d.texelWidth:"",d?"#define CUBEUV_TEXEL_HEIGHT "+d.texelHeight:"",d?"#define CUBEUV_MAX_MIP "+d.maxMip+".0":"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoat?"#define USE_CLEARCOAT":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.dispersion?"#define USE_DISPERSION":"",t.iridescence?"#define USE_IRIDESCENCE":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaTest?"#define USE_ALPHATEST":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.sheen?"#define USE_SHEEN":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexColors||t.instancingColor||t.batchingColor?"#define USE_COLOR":"",t.vertexAlphas?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.gradientMap?"#define USE_GRADIENTMAP":"",t.flatShading?"#define FLAT_SHADED":"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+l:"",t.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",t.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",t.logarithmicDepthBuffer?"#define USE_LOGDEPTHBUF":"",t.reverseDepthBuffer?"#define USE_REVERSEDEPTHBUF":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",t.toneMapping!==is?"#define TONE_MAPPING":"",t.toneMapping!==is?nt.tonemapping_pars_fragment:"",t.toneMapping!==is?SA("toneMapping",t.toneMapping):"",t.dithering?"#define DITHERING":"",t.opaque?"#define OPAQUE":"",nt.colorspace_pars_fragment,MA("linearToOutputTexel",t.outputColorSpace),yA(),t.useDepthPacking?"#define DEPTH_PACKING "+t.depthPacking:"",`
`].filter(oo).join(`
`)),o=Hc(o),o=Ld(o,t),o=Dd(o,t),a=Hc(a),a=Ld(a,t),a=Dd(a,t),o=Nd(o),a=Nd(a),t.isRawShaderMaterial!==!0&&(E=`#version 300 es
`,p=[m,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+p,f=["#define varying in",t.glslVersion===qh?"":"layout(location = 0) out highp vec4 pc_fragColor;",t.glslVersion===qh?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+f);const T=E+p+o,M=E+f+a,k=Rd(s,s.VERTEX_SHADER,T),L=Rd(s,s.FRAGMENT_SHADER,M);s.attachShader(v,k),s.attachShader(v,L),t.index0AttributeName!==void 0?s.bindAttribLocation(v,0,t.index0AttributeName):t.morphTargets===!0&&s.bindAttribLocation(v,0,"position"),s.linkProgram(v);function D(R){if(i.debug.checkShaderErrors){const V=s.getProgramInfoLog(v).trim(),U=s.getShaderInfoLog(k).trim(),K=s.getShaderInfoLog(L).trim();let X=!0,Q=!0;if(s.getProgramParameter(v,s.LINK_STATUS)===!1)if(X=!1,typeof i.debug.onShaderError=="function")i.debug.onShaderError(s,v,k,L);else{const J=Pd(s,k,"vertex"),ne=Pd(s,L,"fragment");console.error("THREE.WebGLProgram: Shader Error "+s.getError()+" - VALIDATE_STATUS "+s.getProgramParameter(v,s.VALIDATE_STATUS)+`

Material Name: `+R.name+`
Material Type: `+R.type+`

Program Info Log: `+V+`
`+J+`
`+ne)}else V!==""?console.warn("THREE.WebGLProgram: Program Info Log:",V):(U===""||K==="")&&(Q=!1);Q&&(R.diagnostics={runnable:X,programLog:V,vertexShader:{log:U,prefix:p},fragmentShader:{log:K,prefix:f}})}s.deleteShader(k),s.deleteShader(L),N=new pa(s,v),w=wA(s,v)}let N;this.getUniforms=function(){return N===void 0&&D(this),N};let w;this.getAttributes=function(){return w===void 0&&D(this),w};let y=t.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return y===!1&&(y=s.getProgramParameter(v,gA)),y},this.destroy=function(){n.releaseStatesOfProgram(this),s.deleteProgram(v),this.program=void 0},this.type=t.shaderType,this.name=t.shaderName,this.id=_A++,this.cacheKey=e,this.usedTimes=1,this.program=v,this.vertexShader=k,this.fragmentShader=L,this}let OA=0;class kA{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(e){const t=e.vertexShader,n=e.fragmentShader,s=this._getShaderStage(t),r=this._getShaderStage(n),o=this._getShaderCacheForMaterial(e);return o.has(s)===!1&&(o.add(s),s.usedTimes++),o.has(r)===!1&&(o.add(r),r.usedTimes++),this}remove(e){const t=this.materialCache.get(e);for(const n of t)n.usedTimes--,n.usedTimes===0&&this.shaderCache.delete(n.code);return this.materialCache.delete(e),this}getVertexShaderID(e){return this._getShaderStage(e.vertexShader).id}getFragmentShaderID(e){return this._getShaderStage(e.fragmentShader).id}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(e){const t=this.materialCache;let n=t.get(e);return n===void 0&&(n=new Set,t.set(e,n)),n}_getShaderStage(e){const t=this.shaderCache;let n=t.get(e);return n===void 0&&(n=new BA(e),t.set(e,n)),n}}class BA{constructor(e){this.id=OA++,this.code=e,this.usedTimes=0}}function zA(i,e,t,n,s,r,o){const a=new vu,l=new kA,c=new Set,u=[],h=s.logarithmicDepthBuffer,d=s.vertexTextures;let m=s.precision;const _={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distanceRGBA",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function v(w){return c.add(w),w===0?"uv":`uv${w}`}function p(w,y,R,V,U){const K=V.fog,X=U.geometry,Q=w.isMeshStandardMaterial?V.environment:null,J=(w.isMeshStandardMaterial?t:e).get(w.envMap||Q),ne=J&&J.mapping===ka?J.image.height:null,fe=_[w.type];w.precision!==null&&(m=s.getMaxPrecision(w.precision),m!==w.precision&&console.warn("THREE.WebGLProgram.getParameters:",w.precision,"not supported, using",m,"instead."));const he=X.morphAttributes.position||X.morphAttributes.normal||X.morphAttributes.color,_e=he!==void 0?he.length:0;let ye=0;X.morphAttributes.position!==void 0&&(ye=1),X.morphAttributes.normal!==void 0&&(ye=2),X.morphAttributes.color!==void 0&&(ye=3);let ge,re,ce,ve;if(fe){const Mt=gi[fe];ge=Mt.vertexShader,re=Mt.fragmentShader}else ge=w.vertexShader,re=w.fragmentShader,l.update(w),ce=l.getVertexShaderID(w),ve=l.getFragmentShaderID(w);const le=i.getRenderTarget(),He=i.state.buffers.depth.getReversed(),Ge=U.isInstancedMesh===!0,Fe=U.isBatchedMesh===!0,lt=!!w.map,Ze=!!w.matcap,ct=!!J,z=!!w.aoMap,Yt=!!w.lightMap,Qe=!!w.bumpMap,tt=!!w.normalMap,We=!!w.displacementMap,ht=!!w.emissiveMap,De=!!w.metalnessMap,C=!!w.roughnessMap,S=w.anisotropy>0,Z=w.clearcoat>0,ee=w.dispersion>0,G=w.iridescence>0,ie=w.sheen>0,be=w.transmission>0,xe=S&&!!w.anisotropyMap,Ae=Z&&!!w.clearcoatMap,Ke=Z&&!!w.clearcoatNormalMap,pe=Z&&!!w.clearcoatRoughnessMap,Me=G&&!!w.iridescenceMap,Oe=G&&!!w.iridescenceThicknessMap,Be=ie&&!!w.sheenColorMap,we=ie&&!!w.sheenRoughnessMap,it=!!w.specularMap,Ye=!!w.specularColorMap,dt=!!w.specularIntensityMap,O=be&&!!w.transmissionMap,Se=be&&!!w.thicknessMap,se=!!w.gradientMap,ae=!!w.alphaMap,Re=w.alphaTest>0,Ce=!!w.alphaHash,Je=!!w.extensions;let Ft=is;w.toneMapped&&(le===null||le.isXRRenderTarget===!0)&&(Ft=i.toneMapping);const tn={shaderID:fe,shaderType:w.type,shaderName:w.name,vertexShader:ge,fragmentShader:re,defines:w.defines,customVertexShaderID:ce,customFragmentShaderID:ve,isRawShaderMaterial:w.isRawShaderMaterial===!0,glslVersion:w.glslVersion,precision:m,batching:Fe,batchingColor:Fe&&U._colorsTexture!==null,instancing:Ge,instancingColor:Ge&&U.instanceColor!==null,instancingMorph:Ge&&U.morphTexture!==null,supportsVertexTextures:d,outputColorSpace:le===null?i.outputColorSpace:le.isXRRenderTarget===!0?le.texture.colorSpace:Ur,alphaToCoverage:!!w.alphaToCoverage,map:lt,matcap:Ze,envMap:ct,envMapMode:ct&&J.mapping,envMapCubeUVHeight:ne,aoMap:z,lightMap:Yt,bumpMap:Qe,normalMap:tt,displacementMap:d&&We,emissiveMap:ht,normalMapObjectSpace:tt&&w.normalMapType===Yb,normalMapTangentSpace:tt&&w.normalMapType===hp,metalnessMap:De,roughnessMap:C,anisotropy:S,anisotropyMap:xe,clearcoat:Z,clearcoatMap:Ae,clearcoatNormalMap:Ke,clearcoatRoughnessMap:pe,dispersion:ee,iridescence:G,iridescenceMap:Me,iridescenceThicknessMap:Oe,sheen:ie,sheenColorMap:Be,sheenRoughnessMap:we,specularMap:it,specularColorMap:Ye,specularIntensityMap:dt,transmission:be,transmissionMap:O,thicknessMap:Se,gradientMap:se,opaque:w.transparent===!1&&w.blending===gr&&w.alphaToCoverage===!1,alphaMap:ae,alphaTest:Re,alphaHash:Ce,combine:w.combine,mapUv:lt&&v(w.map.channel),aoMapUv:z&&v(w.aoMap.channel),lightMapUv:Yt&&v(w.lightMap.channel),bumpMapUv:Qe&&v(w.bumpMap.channel),normalMapUv:tt&&v(w.normalMap.channel),displacementMapUv:We&&v(w.displacementMap.channel),emissiveMapUv:ht&&v(w.emissiveMap.channel),metalnessMapUv:De&&v(w.metalnessMap.channel),roughnessMapUv:C&&v(w.roughnessMap.channel),anisotropyMapUv:xe&&v(w.anisotropyMap.channel),clearcoatMapUv:Ae&&v(w.clearcoatMap.channel),clearcoatNormalMapUv:Ke&&v(w.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:pe&&v(w.clearcoatRoughnessMap.channel),iridescenceMapUv:Me&&v(w.iridescenceMap.channel),iridescenceThicknessMapUv:Oe&&v(w.iridescenceThicknessMap.channel),sheenColorMapUv:Be&&v(w.sheenColorMap.channel),sheenRoughnessMapUv:we&&v(w.sheenRoughnessMap.channel),specularMapUv:it&&v(w.specularMap.channel),specularColorMapUv:Ye&&v(w.specularColorMap.channel),specularIntensityMapUv:dt&&v(w.specularIntensityMap.channel),transmissionMapUv:O&&v(w.transmissionMap.channel),thicknessMapUv:Se&&v(w.thicknessMap.channel),alphaMapUv:ae&&v(w.alphaMap.channel),vertexTangents:!!X.attributes.tangent&&(tt||S),vertexColors:w.vertexColors,vertexAlphas:w.vertexColors===!0&&!!X.attributes.color&&X.attributes.color.itemSize===4,pointsUvs:U.isPoints===!0&&!!X.attributes.uv&&(lt||ae),fog:!!K,useFog:w.fog===!0,fogExp2:!!K&&K.isFogExp2,flatShading:w.flatShading===!0,sizeAttenuation:w.sizeAttenuation===!0,logarithmicDepthBuffer:h,reverseDepthBuffer:He,skinning:U.isSkinnedMesh===!0,morphTargets:X.morphAttributes.position!==void 0,morphNormals:X.morphAttributes.normal!==void 0,morphColors:X.morphAttributes.color!==void 0,morphTargetsCount:_e,morphTextureStride:ye,numDirLights:y.directional.length,numPointLights:y.point.length,numSpotLights:y.spot.length,numSpotLightMaps:y.spotLightMap.length,numRectAreaLights:y.rectArea.length,numHemiLights:y.hemi.length,numDirLightShadows:y.directionalShadowMap.length,numPointLightShadows:y.pointShadowMap.length,numSpotLightShadows:y.spotShadowMap.length,numSpotLightShadowsWithMaps:y.numSpotLightShadowsWithMaps,numLightProbes:y.numLightProbes,numClippingPlanes:o.numPlanes,numClipIntersection:o.numIntersection,dithering:w.dithering,shadowMapEnabled:i.shadowMap.enabled&&R.length>0,shadowMapType:i.shadowMap.type,toneMapping:Ft,decodeVideoTexture:lt&&w.map.isVideoTexture===!0&&pt.getTransfer(w.map.colorSpace)===At,decodeVideoTextureEmissive:ht&&w.emissiveMap.isVideoTexture===!0&&pt.getTransfer(w.emissiveMap.colorSpace)===At,premultipliedAlpha:w.premultipliedAlpha,doubleSided:w.side===Ni,flipSided:w.side===An,useDepthPacking:w.depthPacking>=0,depthPacking:w.depthPacking||0,index0AttributeName:w.index0AttributeName,extensionClipCullDistance:Je&&w.extensions.clipCullDistance===!0&&n.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(Je&&w.extensions.multiDraw===!0||Fe)&&n.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:n.has("KHR_parallel_shader_compile"),customProgramCacheKey:w.customProgramCacheKey()};return tn.vertexUv1s=c.has(1),tn.vertexUv2s=c.has(2),tn.vertexUv3s=c.has(3),c.clear(),tn}function f(w){const y=[];if(w.shaderID?y.push(w.shaderID):(y.push(w.customVertexShaderID),y.push(w.customFragmentShaderID)),w.defines!==void 0)for(const R in w.defines)y.push(R),y.push(w.defines[R]);return w.isRawShaderMaterial===!1&&(E(y,w),T(y,w),y.push(i.outputColorSpace)),y.push(w.customProgramCacheKey),y.join()}function E(w,y){w.push(y.precision),w.push(y.outputColorSpace),w.push(y.envMapMode),w.push(y.envMapCubeUVHeight),w.push(y.mapUv),w.push(y.alphaMapUv),w.push(y.lightMapUv),w.push(y.aoMapUv),w.push(y.bumpMapUv),w.push(y.normalMapUv),w.push(y.displacementMapUv),w.push(y.emissiveMapUv),w.push(y.metalnessMapUv),w.push(y.roughnessMapUv),w.push(y.anisotropyMapUv),w.push(y.clearcoatMapUv),w.push(y.clearcoatNormalMapUv),w.push(y.clearcoatRoughnessMapUv),w.push(y.iridescenceMapUv),w.push(y.iridescenceThicknessMapUv),w.push(y.sheenColorMapUv),w.push(y.sheenRoughnessMapUv),w.push(y.specularMapUv),w.push(y.specularColorMapUv),w.push(y.specularIntensityMapUv),w.push(y.transmissionMapUv),w.push(y.thicknessMapUv),w.push(y.combine),w.push(y.fogExp2),w.push(y.sizeAttenuation),w.push(y.morphTargetsCount),w.push(y.morphAttributeCount),w.push(y.numDirLights),w.push(y.numPointLights),w.push(y.numSpotLights),w.push(y.numSpotLightMaps),w.push(y.numHemiLights),w.push(y.numRectAreaLights),w.push(y.numDirLightShadows),w.push(y.numPointLightShadows),w.push(y.numSpotLightShadows),w.push(y.numSpotLightShadowsWithMaps),w.push(y.numLightProbes),w.push(y.shadowMapType),w.push(y.toneMapping),w.push(y.numClippingPlanes),w.push(y.numClipIntersection),w.push(y.depthPacking)}function T(w,y){a.disableAll(),y.supportsVertexTextures&&a.enable(0),y.instancing&&a.enable(1),y.instancingColor&&a.enable(2),y.instancingMorph&&a.enable(3),y.matcap&&a.enable(4),y.envMap&&a.enable(5),y.normalMapObjectSpace&&a.enable(6),y.normalMapTangentSpace&&a.enable(7),y.clearcoat&&a.enable(8),y.iridescence&&a.enable(9),y.alphaTest&&a.enable(10),y.vertexColors&&a.enable(11),y.vertexAlphas&&a.enable(12),y.vertexUv1s&&a.enable(13),y.vertexUv2s&&a.enable(14),y.vertexUv3s&&a.enable(15),y.vertexTangents&&a.enable(16),y.anisotropy&&a.enable(17),y.alphaHash&&a.enable(18),y.batching&&a.enable(19),y.dispersion&&a.enable(20),y.batchingColor&&a.enable(21),w.push(a.mask),a.disableAll(),y.fog&&a.enable(0),y.useFog&&a.enable(1),y.flatShading&&a.enable(2),y.logarithmicDepthBuffer&&a.enable(3),y.reverseDepthBuffer&&a.enable(4),y.skinning&&a.enable(5),y.morphTargets&&a.enable(6),y.morphNormals&&a.enable(7),y.morphColors&&a.enable(8),y.premultipliedAlpha&&a.enable(9),y.shadowMapEnabled&&a.enable(10),y.doubleSided&&a.enable(11),y.flipSided&&a.enable(12),y.useDepthPacking&&a.enable(13),y.dithering&&a.enable(14),y.transmission&&a.enable(15),y.sheen&&a.enable(16),y.opaque&&a.enable(17),y.pointsUvs&&a.enable(18),y.decodeVideoTexture&&a.enable(19),y.decodeVideoTextureEmissive&&a.enable(20),y.alphaToCoverage&&a.enable(21),w.push(a.mask)}function M(w){const y=_[w.type];let R;if(y){const V=gi[y];R=bE.clone(V.uniforms)}else R=w.uniforms;return R}function k(w,y){let R;for(let V=0,U=u.length;V<U;V++){const K=u[V];if(K.cacheKey===y){R=K,++R.usedTimes;break}}return R===void 0&&(R=new FA(i,y,w,r),u.push(R)),R}function L(w){if(--w.usedTimes===0){const y=u.indexOf(w);u[y]=u[u.length-1],u.pop(),w.destroy()}}function D(w){l.remove(w)}function N(){l.dispose()}return{getParameters:p,getProgramCacheKey:f,getUniforms:M,acquireProgram:k,releaseProgram:L,releaseShaderCache:D,programs:u,dispose:N}}function HA(){let i=new WeakMap;function e(o){return i.has(o)}function t(o){let a=i.get(o);return a===void 0&&(a={},i.set(o,a)),a}function n(o){i.delete(o)}function s(o,a,l){i.get(o)[a]=l}function r(){i=new WeakMap}return{has:e,get:t,remove:n,update:s,dispose:r}}function VA(i,e){return i.groupOrder!==e.groupOrder?i.groupOrder-e.groupOrder:i.renderOrder!==e.renderOrder?i.renderOrder-e.renderOrder:i.material.id!==e.material.id?i.material.id-e.material.id:i.z!==e.z?i.z-e.z:i.id-e.id}function Ud(i,e){return i.groupOrder!==e.groupOrder?i.groupOrder-e.groupOrder:i.renderOrder!==e.renderOrder?i.renderOrder-e.renderOrder:i.z!==e.z?e.z-i.z:i.id-e.id}function Fd(){const i=[];let e=0;const t=[],n=[],s=[];function r(){e=0,t.length=0,n.length=0,s.length=0}function o(h,d,m,_,v,p){let f=i[e];return f===void 0?(f={id:h.id,object:h,geometry:d,material:m,groupOrder:_,renderOrder:h.renderOrder,z:v,group:p},i[e]=f):(f.id=h.id,f.object=h,f.geometry=d,f.material=m,f.groupOrder=_,f.renderOrder=h.renderOrder,f.z=v,f.group=p),e++,f}function a(h,d,m,_,v,p){const f=o(h,d,m,_,v,p);m.transmission>0?n.push(f):m.transparent===!0?s.push(f):t.push(f)}function l(h,d,m,_,v,p){const f=o(h,d,m,_,v,p);m.transmission>0?n.unshift(f):m.transparent===!0?s.unshift(f):t.unshift(f)}function c(h,d){t.length>1&&t.sort(h||VA),n.length>1&&n.sort(d||Ud),s.length>1&&s.sort(d||Ud)}function u(){for(let h=e,d=i.length;h<d;h++){const m=i[h];if(m.id===null)break;m.id=null,m.object=null,m.geometry=null,m.material=null,m.group=null}}return{opaque:t,transmissive:n,transparent:s,init:r,push:a,unshift:l,finish:u,sort:c}}function GA(){let i=new WeakMap;function e(n,s){const r=i.get(n);let o;return r===void 0?(o=new Fd,i.set(n,[o])):s>=r.length?(o=new Fd,r.push(o)):o=r[s],o}function t(){i=new WeakMap}return{get:e,dispose:t}}function WA(){const i={};return{get:function(e){if(i[e.id]!==void 0)return i[e.id];let t;switch(e.type){case"DirectionalLight":t={direction:new Y,color:new at};break;case"SpotLight":t={position:new Y,direction:new Y,color:new at,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":t={position:new Y,color:new at,distance:0,decay:0};break;case"HemisphereLight":t={direction:new Y,skyColor:new at,groundColor:new at};break;case"RectAreaLight":t={color:new at,position:new Y,halfWidth:new Y,halfHeight:new Y};break}return i[e.id]=t,t}}}function $A(){const i={};return{get:function(e){if(i[e.id]!==void 0)return i[e.id];let t;switch(e.type){case"DirectionalLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new mt};break;case"SpotLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new mt};break;case"PointLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new mt,shadowCameraNear:1,shadowCameraFar:1e3};break}return i[e.id]=t,t}}}let XA=0;function qA(i,e){return(e.castShadow?2:0)-(i.castShadow?2:0)+(e.map?1:0)-(i.map?1:0)}function YA(i){const e=new WA,t=$A(),n={version:0,hash:{directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let c=0;c<9;c++)n.probe.push(new Y);const s=new Y,r=new Bt,o=new Bt;function a(c){let u=0,h=0,d=0;for(let w=0;w<9;w++)n.probe[w].set(0,0,0);let m=0,_=0,v=0,p=0,f=0,E=0,T=0,M=0,k=0,L=0,D=0;c.sort(qA);for(let w=0,y=c.length;w<y;w++){const R=c[w],V=R.color,U=R.intensity,K=R.distance,X=R.shadow&&R.shadow.map?R.shadow.map.texture:null;if(R.isAmbientLight)u+=V.r*U,h+=V.g*U,d+=V.b*U;else if(R.isLightProbe){for(let Q=0;Q<9;Q++)n.probe[Q].addScaledVector(R.sh.coefficients[Q],U);D++}else if(R.isDirectionalLight){const Q=e.get(R);if(Q.color.copy(R.color).multiplyScalar(R.intensity),R.castShadow){const J=R.shadow,ne=t.get(R);ne.shadowIntensity=J.intensity,ne.shadowBias=J.bias,ne.shadowNormalBias=J.normalBias,ne.shadowRadius=J.radius,ne.shadowMapSize=J.mapSize,n.directionalShadow[m]=ne,n.directionalShadowMap[m]=X,n.directionalShadowMatrix[m]=R.shadow.matrix,E++}n.directional[m]=Q,m++}else if(R.isSpotLight){const Q=e.get(R);Q.position.setFromMatrixPosition(R.matrixWorld),Q.color.copy(V).multiplyScalar(U),Q.distance=K,Q.coneCos=Math.cos(R.angle),Q.penumbraCos=Math.cos(R.angle*(1-R.penumbra)),Q.decay=R.decay,n.spot[v]=Q;const J=R.shadow;if(R.map&&(n.spotLightMap[k]=R.map,k++,J.updateMatrices(R),R.castShadow&&L++),n.spotLightMatrix[v]=J.matrix,R.castShadow){const ne=t.get(R);ne.shadowIntensity=J.intensity,ne.shadowBias=J.bias,ne.shadowNormalBias=J.normalBias,ne.shadowRadius=J.radius,ne.shadowMapSize=J.mapSize,n.spotShadow[v]=ne,n.spotShadowMap[v]=X,M++}v++}else if(R.isRectAreaLight){const Q=e.get(R);Q.color.copy(V).multiplyScalar(U),Q.halfWidth.set(R.width*.5,0,0),Q.halfHeight.set(0,R.height*.5,0),n.rectArea[p]=Q,p++}else if(R.isPointLight){const Q=e.get(R);if(Q.color.copy(R.color).multiplyScalar(R.intensity),Q.distance=R.distance,Q.decay=R.decay,R.castShadow){const J=R.shadow,ne=t.get(R);ne.shadowIntensity=J.intensity,ne.shadowBias=J.bias,ne.shadowNormalBias=J.normalBias,ne.shadowRadius=J.radius,ne.shadowMapSize=J.mapSize,ne.shadowCameraNear=J.camera.near,ne.shadowCameraFar=J.camera.far,n.pointShadow[_]=ne,n.pointShadowMap[_]=X,n.pointShadowMatrix[_]=R.shadow.matrix,T++}n.point[_]=Q,_++}else if(R.isHemisphereLight){const Q=e.get(R);Q.skyColor.copy(R.color).multiplyScalar(U),Q.groundColor.copy(R.groundColor).multiplyScalar(U),n.hemi[f]=Q,f++}}p>0&&(i.has("OES_texture_float_linear")===!0?(n.rectAreaLTC1=Te.LTC_FLOAT_1,n.rectAreaLTC2=Te.LTC_FLOAT_2):(n.rectAreaLTC1=Te.LTC_HALF_1,n.rectAreaLTC2=Te.LTC_HALF_2)),n.ambient[0]=u,n.ambient[1]=h,n.ambient[2]=d;const N=n.hash;(N.directionalLength!==m||N.pointLength!==_||N.spotLength!==v||N.rectAreaLength!==p||N.hemiLength!==f||N.numDirectionalShadows!==E||N.numPointShadows!==T||N.numSpotShadows!==M||N.numSpotMaps!==k||N.numLightProbes!==D)&&(n.directional.length=m,n.spot.length=v,n.rectArea.length=p,n.point.length=_,n.hemi.length=f,n.directionalShadow.length=E,n.directionalShadowMap.length=E,n.pointShadow.length=T,n.pointShadowMap.length=T,n.spotShadow.length=M,n.spotShadowMap.length=M,n.directionalShadowMatrix.length=E,n.pointShadowMatrix.length=T,n.spotLightMatrix.length=M+k-L,n.spotLightMap.length=k,n.numSpotLightShadowsWithMaps=L,n.numLightProbes=D,N.directionalLength=m,N.pointLength=_,N.spotLength=v,N.rectAreaLength=p,N.hemiLength=f,N.numDirectionalShadows=E,N.numPointShadows=T,N.numSpotShadows=M,N.numSpotMaps=k,N.numLightProbes=D,n.version=XA++)}function l(c,u){let h=0,d=0,m=0,_=0,v=0;const p=u.matrixWorldInverse;for(let f=0,E=c.length;f<E;f++){const T=c[f];if(T.isDirectionalLight){const M=n.directional[h];M.direction.setFromMatrixPosition(T.matrixWorld),s.setFromMatrixPosition(T.target.matrixWorld),M.direction.sub(s),M.direction.transformDirection(p),h++}else if(T.isSpotLight){const M=n.spot[m];M.position.setFromMatrixPosition(T.matrixWorld),M.position.applyMatrix4(p),M.direction.setFromMatrixPosition(T.matrixWorld),s.setFromMatrixPosition(T.target.matrixWorld),M.direction.sub(s),M.direction.transformDirection(p),m++}else if(T.isRectAreaLight){const M=n.rectArea[_];M.position.setFromMatrixPosition(T.matrixWorld),M.position.applyMatrix4(p),o.identity(),r.copy(T.matrixWorld),r.premultiply(p),o.extractRotation(r),M.halfWidth.set(T.width*.5,0,0),M.halfHeight.set(0,T.height*.5,0),M.halfWidth.applyMatrix4(o),M.halfHeight.applyMatrix4(o),_++}else if(T.isPointLight){const M=n.point[d];M.position.setFromMatrixPosition(T.matrixWorld),M.position.applyMatrix4(p),d++}else if(T.isHemisphereLight){const M=n.hemi[v];M.direction.setFromMatrixPosition(T.matrixWorld),M.direction.transformDirection(p),v++}}}return{setup:a,setupView:l,state:n}}function Od(i){const e=new YA(i),t=[],n=[];function s(u){c.camera=u,t.length=0,n.length=0}function r(u){t.push(u)}function o(u){n.push(u)}function a(){e.setup(t)}function l(u){e.setupView(t,u)}const c={lightsArray:t,shadowsArray:n,camera:null,lights:e,transmissionRenderTarget:{}};return{init:s,state:c,setupLights:a,setupLightsView:l,pushLight:r,pushShadow:o}}function jA(i){let e=new WeakMap;function t(s,r=0){const o=e.get(s);let a;return o===void 0?(a=new Od(i),e.set(s,[a])):r>=o.length?(a=new Od(i),o.push(a)):a=o[r],a}function n(){e=new WeakMap}return{get:t,dispose:n}}class KA extends Or{static get type(){return"MeshDepthMaterial"}constructor(e){super(),this.isMeshDepthMaterial=!0,this.depthPacking=Xb,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(e)}copy(e){return super.copy(e),this.depthPacking=e.depthPacking,this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this}}class ZA extends Or{static get type(){return"MeshDistanceMaterial"}constructor(e){super(),this.isMeshDistanceMaterial=!0,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(e)}copy(e){return super.copy(e),this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this}}const JA=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,QA=`uniform sampler2D shadow_pass;
uniform vec2 resolution;
uniform float radius;
#include <packing>
void main() {
	const float samples = float( VSM_SAMPLES );
	float mean = 0.0;
	float squared_mean = 0.0;
	float uvStride = samples <= 1.0 ? 0.0 : 2.0 / ( samples - 1.0 );
	float uvStart = samples <= 1.0 ? 0.0 : - 1.0;
	for ( float i = 0.0; i < samples; i ++ ) {
		float uvOffset = uvStart + i * uvStride;
		#ifdef HORIZONTAL_PASS
			vec2 distribution = unpackRGBATo2Half( texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( uvOffset, 0.0 ) * radius ) / resolution ) );
			mean += distribution.x;
			squared_mean += distribution.y * distribution.y + distribution.x * distribution.x;
		#else
			float depth = unpackRGBAToDepth( texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( 0.0, uvOffset ) * radius ) / resolution ) );
			mean += depth;
			squared_mean += depth * depth;
		#endif
	}
	mean = mean / samples;
	squared_mean = squared_mean / samples;
	float std_dev = sqrt( squared_mean - mean * mean );
	gl_FragColor = pack2HalfToRGBA( vec2( mean, std_dev ) );
}`;function eR(i,e,t){let n=new Mu;const s=new mt,r=new mt,o=new Gt,a=new KA({depthPacking:qb}),l=new ZA,c={},u=t.maxTextureSize,h={[rs]:An,[An]:rs,[Ni]:Ni},d=new os({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new mt},radius:{value:4}},vertexShader:JA,fragmentShader:QA}),m=d.clone();m.defines.HORIZONTAL_PASS=1;const _=new yi;_.setAttribute("position",new xi(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));const v=new pn(_,d),p=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=Zf;let f=this.type;this.render=function(L,D,N){if(p.enabled===!1||p.autoUpdate===!1&&p.needsUpdate===!1||L.length===0)return;const w=i.getRenderTarget(),y=i.getActiveCubeFace(),R=i.getActiveMipmapLevel(),V=i.state;V.setBlending(ns),V.buffers.color.setClear(1,1,1,1),V.buffers.depth.setTest(!0),V.setScissorTest(!1);const U=f!==Di&&this.type===Di,K=f===Di&&this.type!==Di;for(let X=0,Q=L.length;X<Q;X++){const J=L[X],ne=J.shadow;if(ne===void 0){console.warn("THREE.WebGLShadowMap:",J,"has no shadow.");continue}if(ne.autoUpdate===!1&&ne.needsUpdate===!1)continue;s.copy(ne.mapSize);const fe=ne.getFrameExtents();if(s.multiply(fe),r.copy(ne.mapSize),(s.x>u||s.y>u)&&(s.x>u&&(r.x=Math.floor(u/fe.x),s.x=r.x*fe.x,ne.mapSize.x=r.x),s.y>u&&(r.y=Math.floor(u/fe.y),s.y=r.y*fe.y,ne.mapSize.y=r.y)),ne.map===null||U===!0||K===!0){const _e=this.type!==Di?{minFilter:oi,magFilter:oi}:{};ne.map!==null&&ne.map.dispose(),ne.map=new Fs(s.x,s.y,_e),ne.map.texture.name=J.name+".shadowMap",ne.camera.updateProjectionMatrix()}i.setRenderTarget(ne.map),i.clear();const he=ne.getViewportCount();for(let _e=0;_e<he;_e++){const ye=ne.getViewport(_e);o.set(r.x*ye.x,r.y*ye.y,r.x*ye.z,r.y*ye.w),V.viewport(o),ne.updateMatrices(J,_e),n=ne.getFrustum(),M(D,N,ne.camera,J,this.type)}ne.isPointLightShadow!==!0&&this.type===Di&&E(ne,N),ne.needsUpdate=!1}f=this.type,p.needsUpdate=!1,i.setRenderTarget(w,y,R)};function E(L,D){const N=e.update(v);d.defines.VSM_SAMPLES!==L.blurSamples&&(d.defines.VSM_SAMPLES=L.blurSamples,m.defines.VSM_SAMPLES=L.blurSamples,d.needsUpdate=!0,m.needsUpdate=!0),L.mapPass===null&&(L.mapPass=new Fs(s.x,s.y)),d.uniforms.shadow_pass.value=L.map.texture,d.uniforms.resolution.value=L.mapSize,d.uniforms.radius.value=L.radius,i.setRenderTarget(L.mapPass),i.clear(),i.renderBufferDirect(D,null,N,d,v,null),m.uniforms.shadow_pass.value=L.mapPass.texture,m.uniforms.resolution.value=L.mapSize,m.uniforms.radius.value=L.radius,i.setRenderTarget(L.map),i.clear(),i.renderBufferDirect(D,null,N,m,v,null)}function T(L,D,N,w){let y=null;const R=N.isPointLight===!0?L.customDistanceMaterial:L.customDepthMaterial;if(R!==void 0)y=R;else if(y=N.isPointLight===!0?l:a,i.localClippingEnabled&&D.clipShadows===!0&&Array.isArray(D.clippingPlanes)&&D.clippingPlanes.length!==0||D.displacementMap&&D.displacementScale!==0||D.alphaMap&&D.alphaTest>0||D.map&&D.alphaTest>0){const V=y.uuid,U=D.uuid;let K=c[V];K===void 0&&(K={},c[V]=K);let X=K[U];X===void 0&&(X=y.clone(),K[U]=X,D.addEventListener("dispose",k)),y=X}if(y.visible=D.visible,y.wireframe=D.wireframe,w===Di?y.side=D.shadowSide!==null?D.shadowSide:D.side:y.side=D.shadowSide!==null?D.shadowSide:h[D.side],y.alphaMap=D.alphaMap,y.alphaTest=D.alphaTest,y.map=D.map,y.clipShadows=D.clipShadows,y.clippingPlanes=D.clippingPlanes,y.clipIntersection=D.clipIntersection,y.displacementMap=D.displacementMap,y.displacementScale=D.displacementScale,y.displacementBias=D.displacementBias,y.wireframeLinewidth=D.wireframeLinewidth,y.linewidth=D.linewidth,N.isPointLight===!0&&y.isMeshDistanceMaterial===!0){const V=i.properties.get(y);V.light=N}return y}function M(L,D,N,w,y){if(L.visible===!1)return;if(L.layers.test(D.layers)&&(L.isMesh||L.isLine||L.isPoints)&&(L.castShadow||L.receiveShadow&&y===Di)&&(!L.frustumCulled||n.intersectsObject(L))){L.modelViewMatrix.multiplyMatrices(N.matrixWorldInverse,L.matrixWorld);const U=e.update(L),K=L.material;if(Array.isArray(K)){const X=U.groups;for(let Q=0,J=X.length;Q<J;Q++){const ne=X[Q],fe=K[ne.materialIndex];if(fe&&fe.visible){const he=T(L,fe,w,y);L.onBeforeShadow(i,L,D,N,U,he,ne),i.renderBufferDirect(N,null,U,he,L,ne),L.onAfterShadow(i,L,D,N,U,he,ne)}}}else if(K.visible){const X=T(L,K,w,y);L.onBeforeShadow(i,L,D,N,U,X,null),i.renderBufferDirect(N,null,U,X,L,null),L.onAfterShadow(i,L,D,N,U,X,null)}}const V=L.children;for(let U=0,K=V.length;U<K;U++)M(V[U],D,N,w,y)}function k(L){L.target.removeEventListener("dispose",k);for(const N in c){const w=c[N],y=L.target.uuid;y in w&&(w[y].dispose(),delete w[y])}}}const tR={[sc]:rc,[oc]:cc,[ac]:uc,[wr]:lc,[rc]:sc,[cc]:oc,[uc]:ac,[lc]:wr};function nR(i,e){function t(){let O=!1;const Se=new Gt;let se=null;const ae=new Gt(0,0,0,0);return{setMask:function(Re){se!==Re&&!O&&(i.colorMask(Re,Re,Re,Re),se=Re)},setLocked:function(Re){O=Re},setClear:function(Re,Ce,Je,Ft,tn){tn===!0&&(Re*=Ft,Ce*=Ft,Je*=Ft),Se.set(Re,Ce,Je,Ft),ae.equals(Se)===!1&&(i.clearColor(Re,Ce,Je,Ft),ae.copy(Se))},reset:function(){O=!1,se=null,ae.set(-1,0,0,0)}}}function n(){let O=!1,Se=!1,se=null,ae=null,Re=null;return{setReversed:function(Ce){if(Se!==Ce){const Je=e.get("EXT_clip_control");Se?Je.clipControlEXT(Je.LOWER_LEFT_EXT,Je.ZERO_TO_ONE_EXT):Je.clipControlEXT(Je.LOWER_LEFT_EXT,Je.NEGATIVE_ONE_TO_ONE_EXT);const Ft=Re;Re=null,this.setClear(Ft)}Se=Ce},getReversed:function(){return Se},setTest:function(Ce){Ce?le(i.DEPTH_TEST):He(i.DEPTH_TEST)},setMask:function(Ce){se!==Ce&&!O&&(i.depthMask(Ce),se=Ce)},setFunc:function(Ce){if(Se&&(Ce=tR[Ce]),ae!==Ce){switch(Ce){case sc:i.depthFunc(i.NEVER);break;case rc:i.depthFunc(i.ALWAYS);break;case oc:i.depthFunc(i.LESS);break;case wr:i.depthFunc(i.LEQUAL);break;case ac:i.depthFunc(i.EQUAL);break;case lc:i.depthFunc(i.GEQUAL);break;case cc:i.depthFunc(i.GREATER);break;case uc:i.depthFunc(i.NOTEQUAL);break;default:i.depthFunc(i.LEQUAL)}ae=Ce}},setLocked:function(Ce){O=Ce},setClear:function(Ce){Re!==Ce&&(Se&&(Ce=1-Ce),i.clearDepth(Ce),Re=Ce)},reset:function(){O=!1,se=null,ae=null,Re=null,Se=!1}}}function s(){let O=!1,Se=null,se=null,ae=null,Re=null,Ce=null,Je=null,Ft=null,tn=null;return{setTest:function(Mt){O||(Mt?le(i.STENCIL_TEST):He(i.STENCIL_TEST))},setMask:function(Mt){Se!==Mt&&!O&&(i.stencilMask(Mt),Se=Mt)},setFunc:function(Mt,jt,Lt){(se!==Mt||ae!==jt||Re!==Lt)&&(i.stencilFunc(Mt,jt,Lt),se=Mt,ae=jt,Re=Lt)},setOp:function(Mt,jt,Lt){(Ce!==Mt||Je!==jt||Ft!==Lt)&&(i.stencilOp(Mt,jt,Lt),Ce=Mt,Je=jt,Ft=Lt)},setLocked:function(Mt){O=Mt},setClear:function(Mt){tn!==Mt&&(i.clearStencil(Mt),tn=Mt)},reset:function(){O=!1,Se=null,se=null,ae=null,Re=null,Ce=null,Je=null,Ft=null,tn=null}}}const r=new t,o=new n,a=new s,l=new WeakMap,c=new WeakMap;let u={},h={},d=new WeakMap,m=[],_=null,v=!1,p=null,f=null,E=null,T=null,M=null,k=null,L=null,D=new at(0,0,0),N=0,w=!1,y=null,R=null,V=null,U=null,K=null;const X=i.getParameter(i.MAX_COMBINED_TEXTURE_IMAGE_UNITS);let Q=!1,J=0;const ne=i.getParameter(i.VERSION);ne.indexOf("WebGL")!==-1?(J=parseFloat(/^WebGL (\d)/.exec(ne)[1]),Q=J>=1):ne.indexOf("OpenGL ES")!==-1&&(J=parseFloat(/^OpenGL ES (\d)/.exec(ne)[1]),Q=J>=2);let fe=null,he={};const _e=i.getParameter(i.SCISSOR_BOX),ye=i.getParameter(i.VIEWPORT),ge=new Gt().fromArray(_e),re=new Gt().fromArray(ye);function ce(O,Se,se,ae){const Re=new Uint8Array(4),Ce=i.createTexture();i.bindTexture(O,Ce),i.texParameteri(O,i.TEXTURE_MIN_FILTER,i.NEAREST),i.texParameteri(O,i.TEXTURE_MAG_FILTER,i.NEAREST);for(let Je=0;Je<se;Je++)O===i.TEXTURE_3D||O===i.TEXTURE_2D_ARRAY?i.texImage3D(Se,0,i.RGBA,1,1,ae,0,i.RGBA,i.UNSIGNED_BYTE,Re):i.texImage2D(Se+Je,0,i.RGBA,1,1,0,i.RGBA,i.UNSIGNED_BYTE,Re);return Ce}const ve={};ve[i.TEXTURE_2D]=ce(i.TEXTURE_2D,i.TEXTURE_2D,1),ve[i.TEXTURE_CUBE_MAP]=ce(i.TEXTURE_CUBE_MAP,i.TEXTURE_CUBE_MAP_POSITIVE_X,6),ve[i.TEXTURE_2D_ARRAY]=ce(i.TEXTURE_2D_ARRAY,i.TEXTURE_2D_ARRAY,1,1),ve[i.TEXTURE_3D]=ce(i.TEXTURE_3D,i.TEXTURE_3D,1,1),r.setClear(0,0,0,1),o.setClear(1),a.setClear(0),le(i.DEPTH_TEST),o.setFunc(wr),Qe(!1),tt(Hh),le(i.CULL_FACE),z(ns);function le(O){u[O]!==!0&&(i.enable(O),u[O]=!0)}function He(O){u[O]!==!1&&(i.disable(O),u[O]=!1)}function Ge(O,Se){return h[O]!==Se?(i.bindFramebuffer(O,Se),h[O]=Se,O===i.DRAW_FRAMEBUFFER&&(h[i.FRAMEBUFFER]=Se),O===i.FRAMEBUFFER&&(h[i.DRAW_FRAMEBUFFER]=Se),!0):!1}function Fe(O,Se){let se=m,ae=!1;if(O){se=d.get(Se),se===void 0&&(se=[],d.set(Se,se));const Re=O.textures;if(se.length!==Re.length||se[0]!==i.COLOR_ATTACHMENT0){for(let Ce=0,Je=Re.length;Ce<Je;Ce++)se[Ce]=i.COLOR_ATTACHMENT0+Ce;se.length=Re.length,ae=!0}}else se[0]!==i.BACK&&(se[0]=i.BACK,ae=!0);ae&&i.drawBuffers(se)}function lt(O){return _!==O?(i.useProgram(O),_=O,!0):!1}const Ze={[ws]:i.FUNC_ADD,[xb]:i.FUNC_SUBTRACT,[Mb]:i.FUNC_REVERSE_SUBTRACT};Ze[Sb]=i.MIN,Ze[yb]=i.MAX;const ct={[bb]:i.ZERO,[Eb]:i.ONE,[wb]:i.SRC_COLOR,[nc]:i.SRC_ALPHA,[Lb]:i.SRC_ALPHA_SATURATE,[Cb]:i.DST_COLOR,[Ab]:i.DST_ALPHA,[Tb]:i.ONE_MINUS_SRC_COLOR,[ic]:i.ONE_MINUS_SRC_ALPHA,[Pb]:i.ONE_MINUS_DST_COLOR,[Rb]:i.ONE_MINUS_DST_ALPHA,[Db]:i.CONSTANT_COLOR,[Nb]:i.ONE_MINUS_CONSTANT_COLOR,[Ib]:i.CONSTANT_ALPHA,[Ub]:i.ONE_MINUS_CONSTANT_ALPHA};function z(O,Se,se,ae,Re,Ce,Je,Ft,tn,Mt){if(O===ns){v===!0&&(He(i.BLEND),v=!1);return}if(v===!1&&(le(i.BLEND),v=!0),O!==vb){if(O!==p||Mt!==w){if((f!==ws||M!==ws)&&(i.blendEquation(i.FUNC_ADD),f=ws,M=ws),Mt)switch(O){case gr:i.blendFuncSeparate(i.ONE,i.ONE_MINUS_SRC_ALPHA,i.ONE,i.ONE_MINUS_SRC_ALPHA);break;case Vh:i.blendFunc(i.ONE,i.ONE);break;case Gh:i.blendFuncSeparate(i.ZERO,i.ONE_MINUS_SRC_COLOR,i.ZERO,i.ONE);break;case Wh:i.blendFuncSeparate(i.ZERO,i.SRC_COLOR,i.ZERO,i.SRC_ALPHA);break;default:console.error("THREE.WebGLState: Invalid blending: ",O);break}else switch(O){case gr:i.blendFuncSeparate(i.SRC_ALPHA,i.ONE_MINUS_SRC_ALPHA,i.ONE,i.ONE_MINUS_SRC_ALPHA);break;case Vh:i.blendFunc(i.SRC_ALPHA,i.ONE);break;case Gh:i.blendFuncSeparate(i.ZERO,i.ONE_MINUS_SRC_COLOR,i.ZERO,i.ONE);break;case Wh:i.blendFunc(i.ZERO,i.SRC_COLOR);break;default:console.error("THREE.WebGLState: Invalid blending: ",O);break}E=null,T=null,k=null,L=null,D.set(0,0,0),N=0,p=O,w=Mt}return}Re=Re||Se,Ce=Ce||se,Je=Je||ae,(Se!==f||Re!==M)&&(i.blendEquationSeparate(Ze[Se],Ze[Re]),f=Se,M=Re),(se!==E||ae!==T||Ce!==k||Je!==L)&&(i.blendFuncSeparate(ct[se],ct[ae],ct[Ce],ct[Je]),E=se,T=ae,k=Ce,L=Je),(Ft.equals(D)===!1||tn!==N)&&(i.blendColor(Ft.r,Ft.g,Ft.b,tn),D.copy(Ft),N=tn),p=O,w=!1}function Yt(O,Se){O.side===Ni?He(i.CULL_FACE):le(i.CULL_FACE);let se=O.side===An;Se&&(se=!se),Qe(se),O.blending===gr&&O.transparent===!1?z(ns):z(O.blending,O.blendEquation,O.blendSrc,O.blendDst,O.blendEquationAlpha,O.blendSrcAlpha,O.blendDstAlpha,O.blendColor,O.blendAlpha,O.premultipliedAlpha),o.setFunc(O.depthFunc),o.setTest(O.depthTest),o.setMask(O.depthWrite),r.setMask(O.colorWrite);const ae=O.stencilWrite;a.setTest(ae),ae&&(a.setMask(O.stencilWriteMask),a.setFunc(O.stencilFunc,O.stencilRef,O.stencilFuncMask),a.setOp(O.stencilFail,O.stencilZFail,O.stencilZPass)),ht(O.polygonOffset,O.polygonOffsetFactor,O.polygonOffsetUnits),O.alphaToCoverage===!0?le(i.SAMPLE_ALPHA_TO_COVERAGE):He(i.SAMPLE_ALPHA_TO_COVERAGE)}function Qe(O){y!==O&&(O?i.frontFace(i.CW):i.frontFace(i.CCW),y=O)}function tt(O){O!==gb?(le(i.CULL_FACE),O!==R&&(O===Hh?i.cullFace(i.BACK):O===_b?i.cullFace(i.FRONT):i.cullFace(i.FRONT_AND_BACK))):He(i.CULL_FACE),R=O}function We(O){O!==V&&(Q&&i.lineWidth(O),V=O)}function ht(O,Se,se){O?(le(i.POLYGON_OFFSET_FILL),(U!==Se||K!==se)&&(i.polygonOffset(Se,se),U=Se,K=se)):He(i.POLYGON_OFFSET_FILL)}function De(O){O?le(i.SCISSOR_TEST):He(i.SCISSOR_TEST)}function C(O){O===void 0&&(O=i.TEXTURE0+X-1),fe!==O&&(i.activeTexture(O),fe=O)}function S(O,Se,se){se===void 0&&(fe===null?se=i.TEXTURE0+X-1:se=fe);let ae=he[se];ae===void 0&&(ae={type:void 0,texture:void 0},he[se]=ae),(ae.type!==O||ae.texture!==Se)&&(fe!==se&&(i.activeTexture(se),fe=se),i.bindTexture(O,Se||ve[O]),ae.type=O,ae.texture=Se)}function Z(){const O=he[fe];O!==void 0&&O.type!==void 0&&(i.bindTexture(O.type,null),O.type=void 0,O.texture=void 0)}function ee(){try{i.compressedTexImage2D.apply(i,arguments)}catch(O){console.error("THREE.WebGLState:",O)}}function G(){try{i.compressedTexImage3D.apply(i,arguments)}catch(O){console.error("THREE.WebGLState:",O)}}function ie(){try{i.texSubImage2D.apply(i,arguments)}catch(O){console.error("THREE.WebGLState:",O)}}function be(){try{i.texSubImage3D.apply(i,arguments)}catch(O){console.error("THREE.WebGLState:",O)}}function xe(){try{i.compressedTexSubImage2D.apply(i,arguments)}catch(O){console.error("THREE.WebGLState:",O)}}function Ae(){try{i.compressedTexSubImage3D.apply(i,arguments)}catch(O){console.error("THREE.WebGLState:",O)}}function Ke(){try{i.texStorage2D.apply(i,arguments)}catch(O){console.error("THREE.WebGLState:",O)}}function pe(){try{i.texStorage3D.apply(i,arguments)}catch(O){console.error("THREE.WebGLState:",O)}}function Me(){try{i.texImage2D.apply(i,arguments)}catch(O){console.error("THREE.WebGLState:",O)}}function Oe(){try{i.texImage3D.apply(i,arguments)}catch(O){console.error("THREE.WebGLState:",O)}}function Be(O){ge.equals(O)===!1&&(i.scissor(O.x,O.y,O.z,O.w),ge.copy(O))}function we(O){re.equals(O)===!1&&(i.viewport(O.x,O.y,O.z,O.w),re.copy(O))}function it(O,Se){let se=c.get(Se);se===void 0&&(se=new WeakMap,c.set(Se,se));let ae=se.get(O);ae===void 0&&(ae=i.getUniformBlockIndex(Se,O.name),se.set(O,ae))}function Ye(O,Se){const ae=c.get(Se).get(O);l.get(Se)!==ae&&(i.uniformBlockBinding(Se,ae,O.__bindingPointIndex),l.set(Se,ae))}function dt(){i.disable(i.BLEND),i.disable(i.CULL_FACE),i.disable(i.DEPTH_TEST),i.disable(i.POLYGON_OFFSET_FILL),i.disable(i.SCISSOR_TEST),i.disable(i.STENCIL_TEST),i.disable(i.SAMPLE_ALPHA_TO_COVERAGE),i.blendEquation(i.FUNC_ADD),i.blendFunc(i.ONE,i.ZERO),i.blendFuncSeparate(i.ONE,i.ZERO,i.ONE,i.ZERO),i.blendColor(0,0,0,0),i.colorMask(!0,!0,!0,!0),i.clearColor(0,0,0,0),i.depthMask(!0),i.depthFunc(i.LESS),o.setReversed(!1),i.clearDepth(1),i.stencilMask(4294967295),i.stencilFunc(i.ALWAYS,0,4294967295),i.stencilOp(i.KEEP,i.KEEP,i.KEEP),i.clearStencil(0),i.cullFace(i.BACK),i.frontFace(i.CCW),i.polygonOffset(0,0),i.activeTexture(i.TEXTURE0),i.bindFramebuffer(i.FRAMEBUFFER,null),i.bindFramebuffer(i.DRAW_FRAMEBUFFER,null),i.bindFramebuffer(i.READ_FRAMEBUFFER,null),i.useProgram(null),i.lineWidth(1),i.scissor(0,0,i.canvas.width,i.canvas.height),i.viewport(0,0,i.canvas.width,i.canvas.height),u={},fe=null,he={},h={},d=new WeakMap,m=[],_=null,v=!1,p=null,f=null,E=null,T=null,M=null,k=null,L=null,D=new at(0,0,0),N=0,w=!1,y=null,R=null,V=null,U=null,K=null,ge.set(0,0,i.canvas.width,i.canvas.height),re.set(0,0,i.canvas.width,i.canvas.height),r.reset(),o.reset(),a.reset()}return{buffers:{color:r,depth:o,stencil:a},enable:le,disable:He,bindFramebuffer:Ge,drawBuffers:Fe,useProgram:lt,setBlending:z,setMaterial:Yt,setFlipSided:Qe,setCullFace:tt,setLineWidth:We,setPolygonOffset:ht,setScissorTest:De,activeTexture:C,bindTexture:S,unbindTexture:Z,compressedTexImage2D:ee,compressedTexImage3D:G,texImage2D:Me,texImage3D:Oe,updateUBOMapping:it,uniformBlockBinding:Ye,texStorage2D:Ke,texStorage3D:pe,texSubImage2D:ie,texSubImage3D:be,compressedTexSubImage2D:xe,compressedTexSubImage3D:Ae,scissor:Be,viewport:we,reset:dt}}function kd(i,e,t,n){const s=iR(n);switch(t){case sp:return i*e;case op:return i*e;case ap:return i*e*2;case lp:return i*e/s.components*s.byteLength;case pu:return i*e/s.components*s.byteLength;case cp:return i*e*2/s.components*s.byteLength;case mu:return i*e*2/s.components*s.byteLength;case rp:return i*e*3/s.components*s.byteLength;case ri:return i*e*4/s.components*s.byteLength;case gu:return i*e*4/s.components*s.byteLength;case ca:case ua:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*8;case ha:case da:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*16;case mc:case _c:return Math.max(i,16)*Math.max(e,8)/4;case pc:case gc:return Math.max(i,8)*Math.max(e,8)/2;case vc:case xc:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*8;case Mc:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*16;case Sc:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*16;case yc:return Math.floor((i+4)/5)*Math.floor((e+3)/4)*16;case bc:return Math.floor((i+4)/5)*Math.floor((e+4)/5)*16;case Ec:return Math.floor((i+5)/6)*Math.floor((e+4)/5)*16;case wc:return Math.floor((i+5)/6)*Math.floor((e+5)/6)*16;case Tc:return Math.floor((i+7)/8)*Math.floor((e+4)/5)*16;case Ac:return Math.floor((i+7)/8)*Math.floor((e+5)/6)*16;case Rc:return Math.floor((i+7)/8)*Math.floor((e+7)/8)*16;case Cc:return Math.floor((i+9)/10)*Math.floor((e+4)/5)*16;case Pc:return Math.floor((i+9)/10)*Math.floor((e+5)/6)*16;case Lc:return Math.floor((i+9)/10)*Math.floor((e+7)/8)*16;case Dc:return Math.floor((i+9)/10)*Math.floor((e+9)/10)*16;case Nc:return Math.floor((i+11)/12)*Math.floor((e+9)/10)*16;case Ic:return Math.floor((i+11)/12)*Math.floor((e+11)/12)*16;case fa:case Uc:case Fc:return Math.ceil(i/4)*Math.ceil(e/4)*16;case up:case Oc:return Math.ceil(i/4)*Math.ceil(e/4)*8;case kc:case Bc:return Math.ceil(i/4)*Math.ceil(e/4)*16}throw new Error(`Unable to determine texture byte length for ${t} format.`)}function iR(i){switch(i){case Bi:case tp:return{byteLength:1,components:1};case po:case np:case vo:return{byteLength:2,components:1};case du:case fu:return{byteLength:2,components:4};case Us:case hu:case Ii:return{byteLength:4,components:1};case ip:return{byteLength:4,components:3}}throw new Error(`Unknown texture type ${i}.`)}function sR(i,e,t,n,s,r,o){const a=e.has("WEBGL_multisampled_render_to_texture")?e.get("WEBGL_multisampled_render_to_texture"):null,l=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),c=new mt,u=new WeakMap;let h;const d=new WeakMap;let m=!1;try{m=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function _(C,S){return m?new OffscreenCanvas(C,S):ba("canvas")}function v(C,S,Z){let ee=1;const G=De(C);if((G.width>Z||G.height>Z)&&(ee=Z/Math.max(G.width,G.height)),ee<1)if(typeof HTMLImageElement<"u"&&C instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&C instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&C instanceof ImageBitmap||typeof VideoFrame<"u"&&C instanceof VideoFrame){const ie=Math.floor(ee*G.width),be=Math.floor(ee*G.height);h===void 0&&(h=_(ie,be));const xe=S?_(ie,be):h;return xe.width=ie,xe.height=be,xe.getContext("2d").drawImage(C,0,0,ie,be),console.warn("THREE.WebGLRenderer: Texture has been resized from ("+G.width+"x"+G.height+") to ("+ie+"x"+be+")."),xe}else return"data"in C&&console.warn("THREE.WebGLRenderer: Image in DataTexture is too big ("+G.width+"x"+G.height+")."),C;return C}function p(C){return C.generateMipmaps}function f(C){i.generateMipmap(C)}function E(C){return C.isWebGLCubeRenderTarget?i.TEXTURE_CUBE_MAP:C.isWebGL3DRenderTarget?i.TEXTURE_3D:C.isWebGLArrayRenderTarget||C.isCompressedArrayTexture?i.TEXTURE_2D_ARRAY:i.TEXTURE_2D}function T(C,S,Z,ee,G=!1){if(C!==null){if(i[C]!==void 0)return i[C];console.warn("THREE.WebGLRenderer: Attempt to use non-existing WebGL internal format '"+C+"'")}let ie=S;if(S===i.RED&&(Z===i.FLOAT&&(ie=i.R32F),Z===i.HALF_FLOAT&&(ie=i.R16F),Z===i.UNSIGNED_BYTE&&(ie=i.R8)),S===i.RED_INTEGER&&(Z===i.UNSIGNED_BYTE&&(ie=i.R8UI),Z===i.UNSIGNED_SHORT&&(ie=i.R16UI),Z===i.UNSIGNED_INT&&(ie=i.R32UI),Z===i.BYTE&&(ie=i.R8I),Z===i.SHORT&&(ie=i.R16I),Z===i.INT&&(ie=i.R32I)),S===i.RG&&(Z===i.FLOAT&&(ie=i.RG32F),Z===i.HALF_FLOAT&&(ie=i.RG16F),Z===i.UNSIGNED_BYTE&&(ie=i.RG8)),S===i.RG_INTEGER&&(Z===i.UNSIGNED_BYTE&&(ie=i.RG8UI),Z===i.UNSIGNED_SHORT&&(ie=i.RG16UI),Z===i.UNSIGNED_INT&&(ie=i.RG32UI),Z===i.BYTE&&(ie=i.RG8I),Z===i.SHORT&&(ie=i.RG16I),Z===i.INT&&(ie=i.RG32I)),S===i.RGB_INTEGER&&(Z===i.UNSIGNED_BYTE&&(ie=i.RGB8UI),Z===i.UNSIGNED_SHORT&&(ie=i.RGB16UI),Z===i.UNSIGNED_INT&&(ie=i.RGB32UI),Z===i.BYTE&&(ie=i.RGB8I),Z===i.SHORT&&(ie=i.RGB16I),Z===i.INT&&(ie=i.RGB32I)),S===i.RGBA_INTEGER&&(Z===i.UNSIGNED_BYTE&&(ie=i.RGBA8UI),Z===i.UNSIGNED_SHORT&&(ie=i.RGBA16UI),Z===i.UNSIGNED_INT&&(ie=i.RGBA32UI),Z===i.BYTE&&(ie=i.RGBA8I),Z===i.SHORT&&(ie=i.RGBA16I),Z===i.INT&&(ie=i.RGBA32I)),S===i.RGB&&Z===i.UNSIGNED_INT_5_9_9_9_REV&&(ie=i.RGB9_E5),S===i.RGBA){const be=G?Ba:pt.getTransfer(ee);Z===i.FLOAT&&(ie=i.RGBA32F),Z===i.HALF_FLOAT&&(ie=i.RGBA16F),Z===i.UNSIGNED_BYTE&&(ie=be===At?i.SRGB8_ALPHA8:i.RGBA8),Z===i.UNSIGNED_SHORT_4_4_4_4&&(ie=i.RGBA4),Z===i.UNSIGNED_SHORT_5_5_5_1&&(ie=i.RGB5_A1)}return(ie===i.R16F||ie===i.R32F||ie===i.RG16F||ie===i.RG32F||ie===i.RGBA16F||ie===i.RGBA32F)&&e.get("EXT_color_buffer_float"),ie}function M(C,S){let Z;return C?S===null||S===Us||S===Rr?Z=i.DEPTH24_STENCIL8:S===Ii?Z=i.DEPTH32F_STENCIL8:S===po&&(Z=i.DEPTH24_STENCIL8,console.warn("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):S===null||S===Us||S===Rr?Z=i.DEPTH_COMPONENT24:S===Ii?Z=i.DEPTH_COMPONENT32F:S===po&&(Z=i.DEPTH_COMPONENT16),Z}function k(C,S){return p(C)===!0||C.isFramebufferTexture&&C.minFilter!==oi&&C.minFilter!==vi?Math.log2(Math.max(S.width,S.height))+1:C.mipmaps!==void 0&&C.mipmaps.length>0?C.mipmaps.length:C.isCompressedTexture&&Array.isArray(C.image)?S.mipmaps.length:1}function L(C){const S=C.target;S.removeEventListener("dispose",L),N(S),S.isVideoTexture&&u.delete(S)}function D(C){const S=C.target;S.removeEventListener("dispose",D),y(S)}function N(C){const S=n.get(C);if(S.__webglInit===void 0)return;const Z=C.source,ee=d.get(Z);if(ee){const G=ee[S.__cacheKey];G.usedTimes--,G.usedTimes===0&&w(C),Object.keys(ee).length===0&&d.delete(Z)}n.remove(C)}function w(C){const S=n.get(C);i.deleteTexture(S.__webglTexture);const Z=C.source,ee=d.get(Z);delete ee[S.__cacheKey],o.memory.textures--}function y(C){const S=n.get(C);if(C.depthTexture&&(C.depthTexture.dispose(),n.remove(C.depthTexture)),C.isWebGLCubeRenderTarget)for(let ee=0;ee<6;ee++){if(Array.isArray(S.__webglFramebuffer[ee]))for(let G=0;G<S.__webglFramebuffer[ee].length;G++)i.deleteFramebuffer(S.__webglFramebuffer[ee][G]);else i.deleteFramebuffer(S.__webglFramebuffer[ee]);S.__webglDepthbuffer&&i.deleteRenderbuffer(S.__webglDepthbuffer[ee])}else{if(Array.isArray(S.__webglFramebuffer))for(let ee=0;ee<S.__webglFramebuffer.length;ee++)i.deleteFramebuffer(S.__webglFramebuffer[ee]);else i.deleteFramebuffer(S.__webglFramebuffer);if(S.__webglDepthbuffer&&i.deleteRenderbuffer(S.__webglDepthbuffer),S.__webglMultisampledFramebuffer&&i.deleteFramebuffer(S.__webglMultisampledFramebuffer),S.__webglColorRenderbuffer)for(let ee=0;ee<S.__webglColorRenderbuffer.length;ee++)S.__webglColorRenderbuffer[ee]&&i.deleteRenderbuffer(S.__webglColorRenderbuffer[ee]);S.__webglDepthRenderbuffer&&i.deleteRenderbuffer(S.__webglDepthRenderbuffer)}const Z=C.textures;for(let ee=0,G=Z.length;ee<G;ee++){const ie=n.get(Z[ee]);ie.__webglTexture&&(i.deleteTexture(ie.__webglTexture),o.memory.textures--),n.remove(Z[ee])}n.remove(C)}let R=0;function V(){R=0}function U(){const C=R;return C>=s.maxTextures&&console.warn("THREE.WebGLTextures: Trying to use "+C+" texture units while this GPU supports only "+s.maxTextures),R+=1,C}function K(C){const S=[];return S.push(C.wrapS),S.push(C.wrapT),S.push(C.wrapR||0),S.push(C.magFilter),S.push(C.minFilter),S.push(C.anisotropy),S.push(C.internalFormat),S.push(C.format),S.push(C.type),S.push(C.generateMipmaps),S.push(C.premultiplyAlpha),S.push(C.flipY),S.push(C.unpackAlignment),S.push(C.colorSpace),S.join()}function X(C,S){const Z=n.get(C);if(C.isVideoTexture&&We(C),C.isRenderTargetTexture===!1&&C.version>0&&Z.__version!==C.version){const ee=C.image;if(ee===null)console.warn("THREE.WebGLRenderer: Texture marked for update but no image data found.");else if(ee.complete===!1)console.warn("THREE.WebGLRenderer: Texture marked for update but image is incomplete");else{re(Z,C,S);return}}t.bindTexture(i.TEXTURE_2D,Z.__webglTexture,i.TEXTURE0+S)}function Q(C,S){const Z=n.get(C);if(C.version>0&&Z.__version!==C.version){re(Z,C,S);return}t.bindTexture(i.TEXTURE_2D_ARRAY,Z.__webglTexture,i.TEXTURE0+S)}function J(C,S){const Z=n.get(C);if(C.version>0&&Z.__version!==C.version){re(Z,C,S);return}t.bindTexture(i.TEXTURE_3D,Z.__webglTexture,i.TEXTURE0+S)}function ne(C,S){const Z=n.get(C);if(C.version>0&&Z.__version!==C.version){ce(Z,C,S);return}t.bindTexture(i.TEXTURE_CUBE_MAP,Z.__webglTexture,i.TEXTURE0+S)}const fe={[Sa]:i.REPEAT,[As]:i.CLAMP_TO_EDGE,[fc]:i.MIRRORED_REPEAT},he={[oi]:i.NEAREST,[$b]:i.NEAREST_MIPMAP_NEAREST,[Fo]:i.NEAREST_MIPMAP_LINEAR,[vi]:i.LINEAR,[ll]:i.LINEAR_MIPMAP_NEAREST,[Rs]:i.LINEAR_MIPMAP_LINEAR},_e={[jb]:i.NEVER,[tE]:i.ALWAYS,[Kb]:i.LESS,[dp]:i.LEQUAL,[Zb]:i.EQUAL,[eE]:i.GEQUAL,[Jb]:i.GREATER,[Qb]:i.NOTEQUAL};function ye(C,S){if(S.type===Ii&&e.has("OES_texture_float_linear")===!1&&(S.magFilter===vi||S.magFilter===ll||S.magFilter===Fo||S.magFilter===Rs||S.minFilter===vi||S.minFilter===ll||S.minFilter===Fo||S.minFilter===Rs)&&console.warn("THREE.WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),i.texParameteri(C,i.TEXTURE_WRAP_S,fe[S.wrapS]),i.texParameteri(C,i.TEXTURE_WRAP_T,fe[S.wrapT]),(C===i.TEXTURE_3D||C===i.TEXTURE_2D_ARRAY)&&i.texParameteri(C,i.TEXTURE_WRAP_R,fe[S.wrapR]),i.texParameteri(C,i.TEXTURE_MAG_FILTER,he[S.magFilter]),i.texParameteri(C,i.TEXTURE_MIN_FILTER,he[S.minFilter]),S.compareFunction&&(i.texParameteri(C,i.TEXTURE_COMPARE_MODE,i.COMPARE_REF_TO_TEXTURE),i.texParameteri(C,i.TEXTURE_COMPARE_FUNC,_e[S.compareFunction])),e.has("EXT_texture_filter_anisotropic")===!0){if(S.magFilter===oi||S.minFilter!==Fo&&S.minFilter!==Rs||S.type===Ii&&e.has("OES_texture_float_linear")===!1)return;if(S.anisotropy>1||n.get(S).__currentAnisotropy){const Z=e.get("EXT_texture_filter_anisotropic");i.texParameterf(C,Z.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(S.anisotropy,s.getMaxAnisotropy())),n.get(S).__currentAnisotropy=S.anisotropy}}}function ge(C,S){let Z=!1;C.__webglInit===void 0&&(C.__webglInit=!0,S.addEventListener("dispose",L));const ee=S.source;let G=d.get(ee);G===void 0&&(G={},d.set(ee,G));const ie=K(S);if(ie!==C.__cacheKey){G[ie]===void 0&&(G[ie]={texture:i.createTexture(),usedTimes:0},o.memory.textures++,Z=!0),G[ie].usedTimes++;const be=G[C.__cacheKey];be!==void 0&&(G[C.__cacheKey].usedTimes--,be.usedTimes===0&&w(S)),C.__cacheKey=ie,C.__webglTexture=G[ie].texture}return Z}function re(C,S,Z){let ee=i.TEXTURE_2D;(S.isDataArrayTexture||S.isCompressedArrayTexture)&&(ee=i.TEXTURE_2D_ARRAY),S.isData3DTexture&&(ee=i.TEXTURE_3D);const G=ge(C,S),ie=S.source;t.bindTexture(ee,C.__webglTexture,i.TEXTURE0+Z);const be=n.get(ie);if(ie.version!==be.__version||G===!0){t.activeTexture(i.TEXTURE0+Z);const xe=pt.getPrimaries(pt.workingColorSpace),Ae=S.colorSpace===es?null:pt.getPrimaries(S.colorSpace),Ke=S.colorSpace===es||xe===Ae?i.NONE:i.BROWSER_DEFAULT_WEBGL;i.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,S.flipY),i.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,S.premultiplyAlpha),i.pixelStorei(i.UNPACK_ALIGNMENT,S.unpackAlignment),i.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,Ke);let pe=v(S.image,!1,s.maxTextureSize);pe=ht(S,pe);const Me=r.convert(S.format,S.colorSpace),Oe=r.convert(S.type);let Be=T(S.internalFormat,Me,Oe,S.colorSpace,S.isVideoTexture);ye(ee,S);let we;const it=S.mipmaps,Ye=S.isVideoTexture!==!0,dt=be.__version===void 0||G===!0,O=ie.dataReady,Se=k(S,pe);if(S.isDepthTexture)Be=M(S.format===Cr,S.type),dt&&(Ye?t.texStorage2D(i.TEXTURE_2D,1,Be,pe.width,pe.height):t.texImage2D(i.TEXTURE_2D,0,Be,pe.width,pe.height,0,Me,Oe,null));else if(S.isDataTexture)if(it.length>0){Ye&&dt&&t.texStorage2D(i.TEXTURE_2D,Se,Be,it[0].width,it[0].height);for(let se=0,ae=it.length;se<ae;se++)we=it[se],Ye?O&&t.texSubImage2D(i.TEXTURE_2D,se,0,0,we.width,we.height,Me,Oe,we.data):t.texImage2D(i.TEXTURE_2D,se,Be,we.width,we.height,0,Me,Oe,we.data);S.generateMipmaps=!1}else Ye?(dt&&t.texStorage2D(i.TEXTURE_2D,Se,Be,pe.width,pe.height),O&&t.texSubImage2D(i.TEXTURE_2D,0,0,0,pe.width,pe.height,Me,Oe,pe.data)):t.texImage2D(i.TEXTURE_2D,0,Be,pe.width,pe.height,0,Me,Oe,pe.data);else if(S.isCompressedTexture)if(S.isCompressedArrayTexture){Ye&&dt&&t.texStorage3D(i.TEXTURE_2D_ARRAY,Se,Be,it[0].width,it[0].height,pe.depth);for(let se=0,ae=it.length;se<ae;se++)if(we=it[se],S.format!==ri)if(Me!==null)if(Ye){if(O)if(S.layerUpdates.size>0){const Re=kd(we.width,we.height,S.format,S.type);for(const Ce of S.layerUpdates){const Je=we.data.subarray(Ce*Re/we.data.BYTES_PER_ELEMENT,(Ce+1)*Re/we.data.BYTES_PER_ELEMENT);t.compressedTexSubImage3D(i.TEXTURE_2D_ARRAY,se,0,0,Ce,we.width,we.height,1,Me,Je)}S.clearLayerUpdates()}else t.compressedTexSubImage3D(i.TEXTURE_2D_ARRAY,se,0,0,0,we.width,we.height,pe.depth,Me,we.data)}else t.compressedTexImage3D(i.TEXTURE_2D_ARRAY,se,Be,we.width,we.height,pe.depth,0,we.data,0,0);else console.warn("THREE.WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else Ye?O&&t.texSubImage3D(i.TEXTURE_2D_ARRAY,se,0,0,0,we.width,we.height,pe.depth,Me,Oe,we.data):t.texImage3D(i.TEXTURE_2D_ARRAY,se,Be,we.width,we.height,pe.depth,0,Me,Oe,we.data)}else{Ye&&dt&&t.texStorage2D(i.TEXTURE_2D,Se,Be,it[0].width,it[0].height);for(let se=0,ae=it.length;se<ae;se++)we=it[se],S.format!==ri?Me!==null?Ye?O&&t.compressedTexSubImage2D(i.TEXTURE_2D,se,0,0,we.width,we.height,Me,we.data):t.compressedTexImage2D(i.TEXTURE_2D,se,Be,we.width,we.height,0,we.data):console.warn("THREE.WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):Ye?O&&t.texSubImage2D(i.TEXTURE_2D,se,0,0,we.width,we.height,Me,Oe,we.data):t.texImage2D(i.TEXTURE_2D,se,Be,we.width,we.height,0,Me,Oe,we.data)}else if(S.isDataArrayTexture)if(Ye){if(dt&&t.texStorage3D(i.TEXTURE_2D_ARRAY,Se,Be,pe.width,pe.height,pe.depth),O)if(S.layerUpdates.size>0){const se=kd(pe.width,pe.height,S.format,S.type);for(const ae of S.layerUpdates){const Re=pe.data.subarray(ae*se/pe.data.BYTES_PER_ELEMENT,(ae+1)*se/pe.data.BYTES_PER_ELEMENT);t.texSubImage3D(i.TEXTURE_2D_ARRAY,0,0,0,ae,pe.width,pe.height,1,Me,Oe,Re)}S.clearLayerUpdates()}else t.texSubImage3D(i.TEXTURE_2D_ARRAY,0,0,0,0,pe.width,pe.height,pe.depth,Me,Oe,pe.data)}else t.texImage3D(i.TEXTURE_2D_ARRAY,0,Be,pe.width,pe.height,pe.depth,0,Me,Oe,pe.data);else if(S.isData3DTexture)Ye?(dt&&t.texStorage3D(i.TEXTURE_3D,Se,Be,pe.width,pe.height,pe.depth),O&&t.texSubImage3D(i.TEXTURE_3D,0,0,0,0,pe.width,pe.height,pe.depth,Me,Oe,pe.data)):t.texImage3D(i.TEXTURE_3D,0,Be,pe.width,pe.height,pe.depth,0,Me,Oe,pe.data);else if(S.isFramebufferTexture){if(dt)if(Ye)t.texStorage2D(i.TEXTURE_2D,Se,Be,pe.width,pe.height);else{let se=pe.width,ae=pe.height;for(let Re=0;Re<Se;Re++)t.texImage2D(i.TEXTURE_2D,Re,Be,se,ae,0,Me,Oe,null),se>>=1,ae>>=1}}else if(it.length>0){if(Ye&&dt){const se=De(it[0]);t.texStorage2D(i.TEXTURE_2D,Se,Be,se.width,se.height)}for(let se=0,ae=it.length;se<ae;se++)we=it[se],Ye?O&&t.texSubImage2D(i.TEXTURE_2D,se,0,0,Me,Oe,we):t.texImage2D(i.TEXTURE_2D,se,Be,Me,Oe,we);S.generateMipmaps=!1}else if(Ye){if(dt){const se=De(pe);t.texStorage2D(i.TEXTURE_2D,Se,Be,se.width,se.height)}O&&t.texSubImage2D(i.TEXTURE_2D,0,0,0,Me,Oe,pe)}else t.texImage2D(i.TEXTURE_2D,0,Be,Me,Oe,pe);p(S)&&f(ee),be.__version=ie.version,S.onUpdate&&S.onUpdate(S)}C.__version=S.version}function ce(C,S,Z){if(S.image.length!==6)return;const ee=ge(C,S),G=S.source;t.bindTexture(i.TEXTURE_CUBE_MAP,C.__webglTexture,i.TEXTURE0+Z);const ie=n.get(G);if(G.version!==ie.__version||ee===!0){t.activeTexture(i.TEXTURE0+Z);const be=pt.getPrimaries(pt.workingColorSpace),xe=S.colorSpace===es?null:pt.getPrimaries(S.colorSpace),Ae=S.colorSpace===es||be===xe?i.NONE:i.BROWSER_DEFAULT_WEBGL;i.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,S.flipY),i.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,S.premultiplyAlpha),i.pixelStorei(i.UNPACK_ALIGNMENT,S.unpackAlignment),i.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,Ae);const Ke=S.isCompressedTexture||S.image[0].isCompressedTexture,pe=S.image[0]&&S.image[0].isDataTexture,Me=[];for(let ae=0;ae<6;ae++)!Ke&&!pe?Me[ae]=v(S.image[ae],!0,s.maxCubemapSize):Me[ae]=pe?S.image[ae].image:S.image[ae],Me[ae]=ht(S,Me[ae]);const Oe=Me[0],Be=r.convert(S.format,S.colorSpace),we=r.convert(S.type),it=T(S.internalFormat,Be,we,S.colorSpace),Ye=S.isVideoTexture!==!0,dt=ie.__version===void 0||ee===!0,O=G.dataReady;let Se=k(S,Oe);ye(i.TEXTURE_CUBE_MAP,S);let se;if(Ke){Ye&&dt&&t.texStorage2D(i.TEXTURE_CUBE_MAP,Se,it,Oe.width,Oe.height);for(let ae=0;ae<6;ae++){se=Me[ae].mipmaps;for(let Re=0;Re<se.length;Re++){const Ce=se[Re];S.format!==ri?Be!==null?Ye?O&&t.compressedTexSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+ae,Re,0,0,Ce.width,Ce.height,Be,Ce.data):t.compressedTexImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+ae,Re,it,Ce.width,Ce.height,0,Ce.data):console.warn("THREE.WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):Ye?O&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+ae,Re,0,0,Ce.width,Ce.height,Be,we,Ce.data):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+ae,Re,it,Ce.width,Ce.height,0,Be,we,Ce.data)}}}else{if(se=S.mipmaps,Ye&&dt){se.length>0&&Se++;const ae=De(Me[0]);t.texStorage2D(i.TEXTURE_CUBE_MAP,Se,it,ae.width,ae.height)}for(let ae=0;ae<6;ae++)if(pe){Ye?O&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+ae,0,0,0,Me[ae].width,Me[ae].height,Be,we,Me[ae].data):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+ae,0,it,Me[ae].width,Me[ae].height,0,Be,we,Me[ae].data);for(let Re=0;Re<se.length;Re++){const Je=se[Re].image[ae].image;Ye?O&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+ae,Re+1,0,0,Je.width,Je.height,Be,we,Je.data):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+ae,Re+1,it,Je.width,Je.height,0,Be,we,Je.data)}}else{Ye?O&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+ae,0,0,0,Be,we,Me[ae]):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+ae,0,it,Be,we,Me[ae]);for(let Re=0;Re<se.length;Re++){const Ce=se[Re];Ye?O&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+ae,Re+1,0,0,Be,we,Ce.image[ae]):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+ae,Re+1,it,Be,we,Ce.image[ae])}}}p(S)&&f(i.TEXTURE_CUBE_MAP),ie.__version=G.version,S.onUpdate&&S.onUpdate(S)}C.__version=S.version}function ve(C,S,Z,ee,G,ie){const be=r.convert(Z.format,Z.colorSpace),xe=r.convert(Z.type),Ae=T(Z.internalFormat,be,xe,Z.colorSpace),Ke=n.get(S),pe=n.get(Z);if(pe.__renderTarget=S,!Ke.__hasExternalTextures){const Me=Math.max(1,S.width>>ie),Oe=Math.max(1,S.height>>ie);G===i.TEXTURE_3D||G===i.TEXTURE_2D_ARRAY?t.texImage3D(G,ie,Ae,Me,Oe,S.depth,0,be,xe,null):t.texImage2D(G,ie,Ae,Me,Oe,0,be,xe,null)}t.bindFramebuffer(i.FRAMEBUFFER,C),tt(S)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,ee,G,pe.__webglTexture,0,Qe(S)):(G===i.TEXTURE_2D||G>=i.TEXTURE_CUBE_MAP_POSITIVE_X&&G<=i.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&i.framebufferTexture2D(i.FRAMEBUFFER,ee,G,pe.__webglTexture,ie),t.bindFramebuffer(i.FRAMEBUFFER,null)}function le(C,S,Z){if(i.bindRenderbuffer(i.RENDERBUFFER,C),S.depthBuffer){const ee=S.depthTexture,G=ee&&ee.isDepthTexture?ee.type:null,ie=M(S.stencilBuffer,G),be=S.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,xe=Qe(S);tt(S)?a.renderbufferStorageMultisampleEXT(i.RENDERBUFFER,xe,ie,S.width,S.height):Z?i.renderbufferStorageMultisample(i.RENDERBUFFER,xe,ie,S.width,S.height):i.renderbufferStorage(i.RENDERBUFFER,ie,S.width,S.height),i.framebufferRenderbuffer(i.FRAMEBUFFER,be,i.RENDERBUFFER,C)}else{const ee=S.textures;for(let G=0;G<ee.length;G++){const ie=ee[G],be=r.convert(ie.format,ie.colorSpace),xe=r.convert(ie.type),Ae=T(ie.internalFormat,be,xe,ie.colorSpace),Ke=Qe(S);Z&&tt(S)===!1?i.renderbufferStorageMultisample(i.RENDERBUFFER,Ke,Ae,S.width,S.height):tt(S)?a.renderbufferStorageMultisampleEXT(i.RENDERBUFFER,Ke,Ae,S.width,S.height):i.renderbufferStorage(i.RENDERBUFFER,Ae,S.width,S.height)}}i.bindRenderbuffer(i.RENDERBUFFER,null)}function He(C,S){if(S&&S.isWebGLCubeRenderTarget)throw new Error("Depth Texture with cube render targets is not supported");if(t.bindFramebuffer(i.FRAMEBUFFER,C),!(S.depthTexture&&S.depthTexture.isDepthTexture))throw new Error("renderTarget.depthTexture must be an instance of THREE.DepthTexture");const ee=n.get(S.depthTexture);ee.__renderTarget=S,(!ee.__webglTexture||S.depthTexture.image.width!==S.width||S.depthTexture.image.height!==S.height)&&(S.depthTexture.image.width=S.width,S.depthTexture.image.height=S.height,S.depthTexture.needsUpdate=!0),X(S.depthTexture,0);const G=ee.__webglTexture,ie=Qe(S);if(S.depthTexture.format===_r)tt(S)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,i.DEPTH_ATTACHMENT,i.TEXTURE_2D,G,0,ie):i.framebufferTexture2D(i.FRAMEBUFFER,i.DEPTH_ATTACHMENT,i.TEXTURE_2D,G,0);else if(S.depthTexture.format===Cr)tt(S)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,i.DEPTH_STENCIL_ATTACHMENT,i.TEXTURE_2D,G,0,ie):i.framebufferTexture2D(i.FRAMEBUFFER,i.DEPTH_STENCIL_ATTACHMENT,i.TEXTURE_2D,G,0);else throw new Error("Unknown depthTexture format")}function Ge(C){const S=n.get(C),Z=C.isWebGLCubeRenderTarget===!0;if(S.__boundDepthTexture!==C.depthTexture){const ee=C.depthTexture;if(S.__depthDisposeCallback&&S.__depthDisposeCallback(),ee){const G=()=>{delete S.__boundDepthTexture,delete S.__depthDisposeCallback,ee.removeEventListener("dispose",G)};ee.addEventListener("dispose",G),S.__depthDisposeCallback=G}S.__boundDepthTexture=ee}if(C.depthTexture&&!S.__autoAllocateDepthBuffer){if(Z)throw new Error("target.depthTexture not supported in Cube render targets");He(S.__webglFramebuffer,C)}else if(Z){S.__webglDepthbuffer=[];for(let ee=0;ee<6;ee++)if(t.bindFramebuffer(i.FRAMEBUFFER,S.__webglFramebuffer[ee]),S.__webglDepthbuffer[ee]===void 0)S.__webglDepthbuffer[ee]=i.createRenderbuffer(),le(S.__webglDepthbuffer[ee],C,!1);else{const G=C.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,ie=S.__webglDepthbuffer[ee];i.bindRenderbuffer(i.RENDERBUFFER,ie),i.framebufferRenderbuffer(i.FRAMEBUFFER,G,i.RENDERBUFFER,ie)}}else if(t.bindFramebuffer(i.FRAMEBUFFER,S.__webglFramebuffer),S.__webglDepthbuffer===void 0)S.__webglDepthbuffer=i.createRenderbuffer(),le(S.__webglDepthbuffer,C,!1);else{const ee=C.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,G=S.__webglDepthbuffer;i.bindRenderbuffer(i.RENDERBUFFER,G),i.framebufferRenderbuffer(i.FRAMEBUFFER,ee,i.RENDERBUFFER,G)}t.bindFramebuffer(i.FRAMEBUFFER,null)}function Fe(C,S,Z){const ee=n.get(C);S!==void 0&&ve(ee.__webglFramebuffer,C,C.texture,i.COLOR_ATTACHMENT0,i.TEXTURE_2D,0),Z!==void 0&&Ge(C)}function lt(C){const S=C.texture,Z=n.get(C),ee=n.get(S);C.addEventListener("dispose",D);const G=C.textures,ie=C.isWebGLCubeRenderTarget===!0,be=G.length>1;if(be||(ee.__webglTexture===void 0&&(ee.__webglTexture=i.createTexture()),ee.__version=S.version,o.memory.textures++),ie){Z.__webglFramebuffer=[];for(let xe=0;xe<6;xe++)if(S.mipmaps&&S.mipmaps.length>0){Z.__webglFramebuffer[xe]=[];for(let Ae=0;Ae<S.mipmaps.length;Ae++)Z.__webglFramebuffer[xe][Ae]=i.createFramebuffer()}else Z.__webglFramebuffer[xe]=i.createFramebuffer()}else{if(S.mipmaps&&S.mipmaps.length>0){Z.__webglFramebuffer=[];for(let xe=0;xe<S.mipmaps.length;xe++)Z.__webglFramebuffer[xe]=i.createFramebuffer()}else Z.__webglFramebuffer=i.createFramebuffer();if(be)for(let xe=0,Ae=G.length;xe<Ae;xe++){const Ke=n.get(G[xe]);Ke.__webglTexture===void 0&&(Ke.__webglTexture=i.createTexture(),o.memory.textures++)}if(C.samples>0&&tt(C)===!1){Z.__webglMultisampledFramebuffer=i.createFramebuffer(),Z.__webglColorRenderbuffer=[],t.bindFramebuffer(i.FRAMEBUFFER,Z.__webglMultisampledFramebuffer);for(let xe=0;xe<G.length;xe++){const Ae=G[xe];Z.__webglColorRenderbuffer[xe]=i.createRenderbuffer(),i.bindRenderbuffer(i.RENDERBUFFER,Z.__webglColorRenderbuffer[xe]);const Ke=r.convert(Ae.format,Ae.colorSpace),pe=r.convert(Ae.type),Me=T(Ae.internalFormat,Ke,pe,Ae.colorSpace,C.isXRRenderTarget===!0),Oe=Qe(C);i.renderbufferStorageMultisample(i.RENDERBUFFER,Oe,Me,C.width,C.height),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+xe,i.RENDERBUFFER,Z.__webglColorRenderbuffer[xe])}i.bindRenderbuffer(i.RENDERBUFFER,null),C.depthBuffer&&(Z.__webglDepthRenderbuffer=i.createRenderbuffer(),le(Z.__webglDepthRenderbuffer,C,!0)),t.bindFramebuffer(i.FRAMEBUFFER,null)}}if(ie){t.bindTexture(i.TEXTURE_CUBE_MAP,ee.__webglTexture),ye(i.TEXTURE_CUBE_MAP,S);for(let xe=0;xe<6;xe++)if(S.mipmaps&&S.mipmaps.length>0)for(let Ae=0;Ae<S.mipmaps.length;Ae++)ve(Z.__webglFramebuffer[xe][Ae],C,S,i.COLOR_ATTACHMENT0,i.TEXTURE_CUBE_MAP_POSITIVE_X+xe,Ae);else ve(Z.__webglFramebuffer[xe],C,S,i.COLOR_ATTACHMENT0,i.TEXTURE_CUBE_MAP_POSITIVE_X+xe,0);p(S)&&f(i.TEXTURE_CUBE_MAP),t.unbindTexture()}else if(be){for(let xe=0,Ae=G.length;xe<Ae;xe++){const Ke=G[xe],pe=n.get(Ke);t.bindTexture(i.TEXTURE_2D,pe.__webglTexture),ye(i.TEXTURE_2D,Ke),ve(Z.__webglFramebuffer,C,Ke,i.COLOR_ATTACHMENT0+xe,i.TEXTURE_2D,0),p(Ke)&&f(i.TEXTURE_2D)}t.unbindTexture()}else{let xe=i.TEXTURE_2D;if((C.isWebGL3DRenderTarget||C.isWebGLArrayRenderTarget)&&(xe=C.isWebGL3DRenderTarget?i.TEXTURE_3D:i.TEXTURE_2D_ARRAY),t.bindTexture(xe,ee.__webglTexture),ye(xe,S),S.mipmaps&&S.mipmaps.length>0)for(let Ae=0;Ae<S.mipmaps.length;Ae++)ve(Z.__webglFramebuffer[Ae],C,S,i.COLOR_ATTACHMENT0,xe,Ae);else ve(Z.__webglFramebuffer,C,S,i.COLOR_ATTACHMENT0,xe,0);p(S)&&f(xe),t.unbindTexture()}C.depthBuffer&&Ge(C)}function Ze(C){const S=C.textures;for(let Z=0,ee=S.length;Z<ee;Z++){const G=S[Z];if(p(G)){const ie=E(C),be=n.get(G).__webglTexture;t.bindTexture(ie,be),f(ie),t.unbindTexture()}}}const ct=[],z=[];function Yt(C){if(C.samples>0){if(tt(C)===!1){const S=C.textures,Z=C.width,ee=C.height;let G=i.COLOR_BUFFER_BIT;const ie=C.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,be=n.get(C),xe=S.length>1;if(xe)for(let Ae=0;Ae<S.length;Ae++)t.bindFramebuffer(i.FRAMEBUFFER,be.__webglMultisampledFramebuffer),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+Ae,i.RENDERBUFFER,null),t.bindFramebuffer(i.FRAMEBUFFER,be.__webglFramebuffer),i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0+Ae,i.TEXTURE_2D,null,0);t.bindFramebuffer(i.READ_FRAMEBUFFER,be.__webglMultisampledFramebuffer),t.bindFramebuffer(i.DRAW_FRAMEBUFFER,be.__webglFramebuffer);for(let Ae=0;Ae<S.length;Ae++){if(C.resolveDepthBuffer&&(C.depthBuffer&&(G|=i.DEPTH_BUFFER_BIT),C.stencilBuffer&&C.resolveStencilBuffer&&(G|=i.STENCIL_BUFFER_BIT)),xe){i.framebufferRenderbuffer(i.READ_FRAMEBUFFER,i.COLOR_ATTACHMENT0,i.RENDERBUFFER,be.__webglColorRenderbuffer[Ae]);const Ke=n.get(S[Ae]).__webglTexture;i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0,i.TEXTURE_2D,Ke,0)}i.blitFramebuffer(0,0,Z,ee,0,0,Z,ee,G,i.NEAREST),l===!0&&(ct.length=0,z.length=0,ct.push(i.COLOR_ATTACHMENT0+Ae),C.depthBuffer&&C.resolveDepthBuffer===!1&&(ct.push(ie),z.push(ie),i.invalidateFramebuffer(i.DRAW_FRAMEBUFFER,z)),i.invalidateFramebuffer(i.READ_FRAMEBUFFER,ct))}if(t.bindFramebuffer(i.READ_FRAMEBUFFER,null),t.bindFramebuffer(i.DRAW_FRAMEBUFFER,null),xe)for(let Ae=0;Ae<S.length;Ae++){t.bindFramebuffer(i.FRAMEBUFFER,be.__webglMultisampledFramebuffer),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+Ae,i.RENDERBUFFER,be.__webglColorRenderbuffer[Ae]);const Ke=n.get(S[Ae]).__webglTexture;t.bindFramebuffer(i.FRAMEBUFFER,be.__webglFramebuffer),i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0+Ae,i.TEXTURE_2D,Ke,0)}t.bindFramebuffer(i.DRAW_FRAMEBUFFER,be.__webglMultisampledFramebuffer)}else if(C.depthBuffer&&C.resolveDepthBuffer===!1&&l){const S=C.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;i.invalidateFramebuffer(i.DRAW_FRAMEBUFFER,[S])}}}function Qe(C){return Math.min(s.maxSamples,C.samples)}function tt(C){const S=n.get(C);return C.samples>0&&e.has("WEBGL_multisampled_render_to_texture")===!0&&S.__useRenderToTexture!==!1}function We(C){const S=o.render.frame;u.get(C)!==S&&(u.set(C,S),C.update())}function ht(C,S){const Z=C.colorSpace,ee=C.format,G=C.type;return C.isCompressedTexture===!0||C.isVideoTexture===!0||Z!==Ur&&Z!==es&&(pt.getTransfer(Z)===At?(ee!==ri||G!==Bi)&&console.warn("THREE.WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):console.error("THREE.WebGLTextures: Unsupported texture color space:",Z)),S}function De(C){return typeof HTMLImageElement<"u"&&C instanceof HTMLImageElement?(c.width=C.naturalWidth||C.width,c.height=C.naturalHeight||C.height):typeof VideoFrame<"u"&&C instanceof VideoFrame?(c.width=C.displayWidth,c.height=C.displayHeight):(c.width=C.width,c.height=C.height),c}this.allocateTextureUnit=U,this.resetTextureUnits=V,this.setTexture2D=X,this.setTexture2DArray=Q,this.setTexture3D=J,this.setTextureCube=ne,this.rebindTextures=Fe,this.setupRenderTarget=lt,this.updateRenderTargetMipmap=Ze,this.updateMultisampleRenderTarget=Yt,this.setupDepthRenderbuffer=Ge,this.setupFrameBufferTexture=ve,this.useMultisampledRTT=tt}function rR(i,e){function t(n,s=es){let r;const o=pt.getTransfer(s);if(n===Bi)return i.UNSIGNED_BYTE;if(n===du)return i.UNSIGNED_SHORT_4_4_4_4;if(n===fu)return i.UNSIGNED_SHORT_5_5_5_1;if(n===ip)return i.UNSIGNED_INT_5_9_9_9_REV;if(n===tp)return i.BYTE;if(n===np)return i.SHORT;if(n===po)return i.UNSIGNED_SHORT;if(n===hu)return i.INT;if(n===Us)return i.UNSIGNED_INT;if(n===Ii)return i.FLOAT;if(n===vo)return i.HALF_FLOAT;if(n===sp)return i.ALPHA;if(n===rp)return i.RGB;if(n===ri)return i.RGBA;if(n===op)return i.LUMINANCE;if(n===ap)return i.LUMINANCE_ALPHA;if(n===_r)return i.DEPTH_COMPONENT;if(n===Cr)return i.DEPTH_STENCIL;if(n===lp)return i.RED;if(n===pu)return i.RED_INTEGER;if(n===cp)return i.RG;if(n===mu)return i.RG_INTEGER;if(n===gu)return i.RGBA_INTEGER;if(n===ca||n===ua||n===ha||n===da)if(o===At)if(r=e.get("WEBGL_compressed_texture_s3tc_srgb"),r!==null){if(n===ca)return r.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(n===ua)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(n===ha)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(n===da)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(r=e.get("WEBGL_compressed_texture_s3tc"),r!==null){if(n===ca)return r.COMPRESSED_RGB_S3TC_DXT1_EXT;if(n===ua)return r.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(n===ha)return r.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(n===da)return r.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(n===pc||n===mc||n===gc||n===_c)if(r=e.get("WEBGL_compressed_texture_pvrtc"),r!==null){if(n===pc)return r.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(n===mc)return r.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(n===gc)return r.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(n===_c)return r.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(n===vc||n===xc||n===Mc)if(r=e.get("WEBGL_compressed_texture_etc"),r!==null){if(n===vc||n===xc)return o===At?r.COMPRESSED_SRGB8_ETC2:r.COMPRESSED_RGB8_ETC2;if(n===Mc)return o===At?r.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:r.COMPRESSED_RGBA8_ETC2_EAC}else return null;if(n===Sc||n===yc||n===bc||n===Ec||n===wc||n===Tc||n===Ac||n===Rc||n===Cc||n===Pc||n===Lc||n===Dc||n===Nc||n===Ic)if(r=e.get("WEBGL_compressed_texture_astc"),r!==null){if(n===Sc)return o===At?r.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:r.COMPRESSED_RGBA_ASTC_4x4_KHR;if(n===yc)return o===At?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:r.COMPRESSED_RGBA_ASTC_5x4_KHR;if(n===bc)return o===At?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:r.COMPRESSED_RGBA_ASTC_5x5_KHR;if(n===Ec)return o===At?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:r.COMPRESSED_RGBA_ASTC_6x5_KHR;if(n===wc)return o===At?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:r.COMPRESSED_RGBA_ASTC_6x6_KHR;if(n===Tc)return o===At?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:r.COMPRESSED_RGBA_ASTC_8x5_KHR;if(n===Ac)return o===At?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:r.COMPRESSED_RGBA_ASTC_8x6_KHR;if(n===Rc)return o===At?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:r.COMPRESSED_RGBA_ASTC_8x8_KHR;if(n===Cc)return o===At?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:r.COMPRESSED_RGBA_ASTC_10x5_KHR;if(n===Pc)return o===At?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:r.COMPRESSED_RGBA_ASTC_10x6_KHR;if(n===Lc)return o===At?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:r.COMPRESSED_RGBA_ASTC_10x8_KHR;if(n===Dc)return o===At?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:r.COMPRESSED_RGBA_ASTC_10x10_KHR;if(n===Nc)return o===At?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:r.COMPRESSED_RGBA_ASTC_12x10_KHR;if(n===Ic)return o===At?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:r.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(n===fa||n===Uc||n===Fc)if(r=e.get("EXT_texture_compression_bptc"),r!==null){if(n===fa)return o===At?r.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:r.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(n===Uc)return r.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(n===Fc)return r.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(n===up||n===Oc||n===kc||n===Bc)if(r=e.get("EXT_texture_compression_rgtc"),r!==null){if(n===fa)return r.COMPRESSED_RED_RGTC1_EXT;if(n===Oc)return r.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(n===kc)return r.COMPRESSED_RED_GREEN_RGTC2_EXT;if(n===Bc)return r.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return n===Rr?i.UNSIGNED_INT_24_8:i[n]!==void 0?i[n]:null}return{convert:t}}class oR extends Xn{constructor(e=[]){super(),this.isArrayCamera=!0,this.cameras=e}}class ts extends Jt{constructor(){super(),this.isGroup=!0,this.type="Group"}}const aR={type:"move"};class Ol{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new ts,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new ts,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new Y,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new Y),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new ts,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new Y,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new Y),this._grip}dispatchEvent(e){return this._targetRay!==null&&this._targetRay.dispatchEvent(e),this._grip!==null&&this._grip.dispatchEvent(e),this._hand!==null&&this._hand.dispatchEvent(e),this}connect(e){if(e&&e.hand){const t=this._hand;if(t)for(const n of e.hand.values())this._getHandJoint(t,n)}return this.dispatchEvent({type:"connected",data:e}),this}disconnect(e){return this.dispatchEvent({type:"disconnected",data:e}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(e,t,n){let s=null,r=null,o=null;const a=this._targetRay,l=this._grip,c=this._hand;if(e&&t.session.visibilityState!=="visible-blurred"){if(c&&e.hand){o=!0;for(const v of e.hand.values()){const p=t.getJointPose(v,n),f=this._getHandJoint(c,v);p!==null&&(f.matrix.fromArray(p.transform.matrix),f.matrix.decompose(f.position,f.rotation,f.scale),f.matrixWorldNeedsUpdate=!0,f.jointRadius=p.radius),f.visible=p!==null}const u=c.joints["index-finger-tip"],h=c.joints["thumb-tip"],d=u.position.distanceTo(h.position),m=.02,_=.005;c.inputState.pinching&&d>m+_?(c.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:e.handedness,target:this})):!c.inputState.pinching&&d<=m-_&&(c.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:e.handedness,target:this}))}else l!==null&&e.gripSpace&&(r=t.getPose(e.gripSpace,n),r!==null&&(l.matrix.fromArray(r.transform.matrix),l.matrix.decompose(l.position,l.rotation,l.scale),l.matrixWorldNeedsUpdate=!0,r.linearVelocity?(l.hasLinearVelocity=!0,l.linearVelocity.copy(r.linearVelocity)):l.hasLinearVelocity=!1,r.angularVelocity?(l.hasAngularVelocity=!0,l.angularVelocity.copy(r.angularVelocity)):l.hasAngularVelocity=!1));a!==null&&(s=t.getPose(e.targetRaySpace,n),s===null&&r!==null&&(s=r),s!==null&&(a.matrix.fromArray(s.transform.matrix),a.matrix.decompose(a.position,a.rotation,a.scale),a.matrixWorldNeedsUpdate=!0,s.linearVelocity?(a.hasLinearVelocity=!0,a.linearVelocity.copy(s.linearVelocity)):a.hasLinearVelocity=!1,s.angularVelocity?(a.hasAngularVelocity=!0,a.angularVelocity.copy(s.angularVelocity)):a.hasAngularVelocity=!1,this.dispatchEvent(aR)))}return a!==null&&(a.visible=s!==null),l!==null&&(l.visible=r!==null),c!==null&&(c.visible=o!==null),this}_getHandJoint(e,t){if(e.joints[t.jointName]===void 0){const n=new ts;n.matrixAutoUpdate=!1,n.visible=!1,e.joints[t.jointName]=n,e.add(n)}return e.joints[t.jointName]}}const lR=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,cR=`
uniform sampler2DArray depthColor;
uniform float depthWidth;
uniform float depthHeight;

void main() {

	vec2 coord = vec2( gl_FragCoord.x / depthWidth, gl_FragCoord.y / depthHeight );

	if ( coord.x >= 1.0 ) {

		gl_FragDepth = texture( depthColor, vec3( coord.x - 1.0, coord.y, 1 ) ).r;

	} else {

		gl_FragDepth = texture( depthColor, vec3( coord.x, coord.y, 0 ) ).r;

	}

}`;class uR{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(e,t,n){if(this.texture===null){const s=new yn,r=e.properties.get(s);r.__webglTexture=t.texture,(t.depthNear!=n.depthNear||t.depthFar!=n.depthFar)&&(this.depthNear=t.depthNear,this.depthFar=t.depthFar),this.texture=s}}getMesh(e){if(this.texture!==null&&this.mesh===null){const t=e.cameras[0].viewport,n=new os({vertexShader:lR,fragmentShader:cR,uniforms:{depthColor:{value:this.texture},depthWidth:{value:t.z},depthHeight:{value:t.w}}});this.mesh=new pn(new yo(20,20),n)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}}class hR extends Fr{constructor(e,t){super();const n=this;let s=null,r=1,o=null,a="local-floor",l=1,c=null,u=null,h=null,d=null,m=null,_=null;const v=new uR,p=t.getContextAttributes();let f=null,E=null;const T=[],M=[],k=new mt;let L=null;const D=new Xn;D.viewport=new Gt;const N=new Xn;N.viewport=new Gt;const w=[D,N],y=new oR;let R=null,V=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(re){let ce=T[re];return ce===void 0&&(ce=new Ol,T[re]=ce),ce.getTargetRaySpace()},this.getControllerGrip=function(re){let ce=T[re];return ce===void 0&&(ce=new Ol,T[re]=ce),ce.getGripSpace()},this.getHand=function(re){let ce=T[re];return ce===void 0&&(ce=new Ol,T[re]=ce),ce.getHandSpace()};function U(re){const ce=M.indexOf(re.inputSource);if(ce===-1)return;const ve=T[ce];ve!==void 0&&(ve.update(re.inputSource,re.frame,c||o),ve.dispatchEvent({type:re.type,data:re.inputSource}))}function K(){s.removeEventListener("select",U),s.removeEventListener("selectstart",U),s.removeEventListener("selectend",U),s.removeEventListener("squeeze",U),s.removeEventListener("squeezestart",U),s.removeEventListener("squeezeend",U),s.removeEventListener("end",K),s.removeEventListener("inputsourceschange",X);for(let re=0;re<T.length;re++){const ce=M[re];ce!==null&&(M[re]=null,T[re].disconnect(ce))}R=null,V=null,v.reset(),e.setRenderTarget(f),m=null,d=null,h=null,s=null,E=null,ge.stop(),n.isPresenting=!1,e.setPixelRatio(L),e.setSize(k.width,k.height,!1),n.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(re){r=re,n.isPresenting===!0&&console.warn("THREE.WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(re){a=re,n.isPresenting===!0&&console.warn("THREE.WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return c||o},this.setReferenceSpace=function(re){c=re},this.getBaseLayer=function(){return d!==null?d:m},this.getBinding=function(){return h},this.getFrame=function(){return _},this.getSession=function(){return s},this.setSession=async function(re){if(s=re,s!==null){if(f=e.getRenderTarget(),s.addEventListener("select",U),s.addEventListener("selectstart",U),s.addEventListener("selectend",U),s.addEventListener("squeeze",U),s.addEventListener("squeezestart",U),s.addEventListener("squeezeend",U),s.addEventListener("end",K),s.addEventListener("inputsourceschange",X),p.xrCompatible!==!0&&await t.makeXRCompatible(),L=e.getPixelRatio(),e.getSize(k),s.renderState.layers===void 0){const ce={antialias:p.antialias,alpha:!0,depth:p.depth,stencil:p.stencil,framebufferScaleFactor:r};m=new XRWebGLLayer(s,t,ce),s.updateRenderState({baseLayer:m}),e.setPixelRatio(1),e.setSize(m.framebufferWidth,m.framebufferHeight,!1),E=new Fs(m.framebufferWidth,m.framebufferHeight,{format:ri,type:Bi,colorSpace:e.outputColorSpace,stencilBuffer:p.stencil})}else{let ce=null,ve=null,le=null;p.depth&&(le=p.stencil?t.DEPTH24_STENCIL8:t.DEPTH_COMPONENT24,ce=p.stencil?Cr:_r,ve=p.stencil?Rr:Us);const He={colorFormat:t.RGBA8,depthFormat:le,scaleFactor:r};h=new XRWebGLBinding(s,t),d=h.createProjectionLayer(He),s.updateRenderState({layers:[d]}),e.setPixelRatio(1),e.setSize(d.textureWidth,d.textureHeight,!1),E=new Fs(d.textureWidth,d.textureHeight,{format:ri,type:Bi,depthTexture:new Ep(d.textureWidth,d.textureHeight,ve,void 0,void 0,void 0,void 0,void 0,void 0,ce),stencilBuffer:p.stencil,colorSpace:e.outputColorSpace,samples:p.antialias?4:0,resolveDepthBuffer:d.ignoreDepthValues===!1})}E.isXRRenderTarget=!0,this.setFoveation(l),c=null,o=await s.requestReferenceSpace(a),ge.setContext(s),ge.start(),n.isPresenting=!0,n.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(s!==null)return s.environmentBlendMode},this.getDepthTexture=function(){return v.getDepthTexture()};function X(re){for(let ce=0;ce<re.removed.length;ce++){const ve=re.removed[ce],le=M.indexOf(ve);le>=0&&(M[le]=null,T[le].disconnect(ve))}for(let ce=0;ce<re.added.length;ce++){const ve=re.added[ce];let le=M.indexOf(ve);if(le===-1){for(let Ge=0;Ge<T.length;Ge++)if(Ge>=M.length){M.push(ve),le=Ge;break}else if(M[Ge]===null){M[Ge]=ve,le=Ge;break}if(le===-1)break}const He=T[le];He&&He.connect(ve)}}const Q=new Y,J=new Y;function ne(re,ce,ve){Q.setFromMatrixPosition(ce.matrixWorld),J.setFromMatrixPosition(ve.matrixWorld);const le=Q.distanceTo(J),He=ce.projectionMatrix.elements,Ge=ve.projectionMatrix.elements,Fe=He[14]/(He[10]-1),lt=He[14]/(He[10]+1),Ze=(He[9]+1)/He[5],ct=(He[9]-1)/He[5],z=(He[8]-1)/He[0],Yt=(Ge[8]+1)/Ge[0],Qe=Fe*z,tt=Fe*Yt,We=le/(-z+Yt),ht=We*-z;if(ce.matrixWorld.decompose(re.position,re.quaternion,re.scale),re.translateX(ht),re.translateZ(We),re.matrixWorld.compose(re.position,re.quaternion,re.scale),re.matrixWorldInverse.copy(re.matrixWorld).invert(),He[10]===-1)re.projectionMatrix.copy(ce.projectionMatrix),re.projectionMatrixInverse.copy(ce.projectionMatrixInverse);else{const De=Fe+We,C=lt+We,S=Qe-ht,Z=tt+(le-ht),ee=Ze*lt/C*De,G=ct*lt/C*De;re.projectionMatrix.makePerspective(S,Z,ee,G,De,C),re.projectionMatrixInverse.copy(re.projectionMatrix).invert()}}function fe(re,ce){ce===null?re.matrixWorld.copy(re.matrix):re.matrixWorld.multiplyMatrices(ce.matrixWorld,re.matrix),re.matrixWorldInverse.copy(re.matrixWorld).invert()}this.updateCamera=function(re){if(s===null)return;let ce=re.near,ve=re.far;v.texture!==null&&(v.depthNear>0&&(ce=v.depthNear),v.depthFar>0&&(ve=v.depthFar)),y.near=N.near=D.near=ce,y.far=N.far=D.far=ve,(R!==y.near||V!==y.far)&&(s.updateRenderState({depthNear:y.near,depthFar:y.far}),R=y.near,V=y.far),D.layers.mask=re.layers.mask|2,N.layers.mask=re.layers.mask|4,y.layers.mask=D.layers.mask|N.layers.mask;const le=re.parent,He=y.cameras;fe(y,le);for(let Ge=0;Ge<He.length;Ge++)fe(He[Ge],le);He.length===2?ne(y,D,N):y.projectionMatrix.copy(D.projectionMatrix),he(re,y,le)};function he(re,ce,ve){ve===null?re.matrix.copy(ce.matrixWorld):(re.matrix.copy(ve.matrixWorld),re.matrix.invert(),re.matrix.multiply(ce.matrixWorld)),re.matrix.decompose(re.position,re.quaternion,re.scale),re.updateMatrixWorld(!0),re.projectionMatrix.copy(ce.projectionMatrix),re.projectionMatrixInverse.copy(ce.projectionMatrixInverse),re.isPerspectiveCamera&&(re.fov=zc*2*Math.atan(1/re.projectionMatrix.elements[5]),re.zoom=1)}this.getCamera=function(){return y},this.getFoveation=function(){if(!(d===null&&m===null))return l},this.setFoveation=function(re){l=re,d!==null&&(d.fixedFoveation=re),m!==null&&m.fixedFoveation!==void 0&&(m.fixedFoveation=re)},this.hasDepthSensing=function(){return v.texture!==null},this.getDepthSensingMesh=function(){return v.getMesh(y)};let _e=null;function ye(re,ce){if(u=ce.getViewerPose(c||o),_=ce,u!==null){const ve=u.views;m!==null&&(e.setRenderTargetFramebuffer(E,m.framebuffer),e.setRenderTarget(E));let le=!1;ve.length!==y.cameras.length&&(y.cameras.length=0,le=!0);for(let Ge=0;Ge<ve.length;Ge++){const Fe=ve[Ge];let lt=null;if(m!==null)lt=m.getViewport(Fe);else{const ct=h.getViewSubImage(d,Fe);lt=ct.viewport,Ge===0&&(e.setRenderTargetTextures(E,ct.colorTexture,d.ignoreDepthValues?void 0:ct.depthStencilTexture),e.setRenderTarget(E))}let Ze=w[Ge];Ze===void 0&&(Ze=new Xn,Ze.layers.enable(Ge),Ze.viewport=new Gt,w[Ge]=Ze),Ze.matrix.fromArray(Fe.transform.matrix),Ze.matrix.decompose(Ze.position,Ze.quaternion,Ze.scale),Ze.projectionMatrix.fromArray(Fe.projectionMatrix),Ze.projectionMatrixInverse.copy(Ze.projectionMatrix).invert(),Ze.viewport.set(lt.x,lt.y,lt.width,lt.height),Ge===0&&(y.matrix.copy(Ze.matrix),y.matrix.decompose(y.position,y.quaternion,y.scale)),le===!0&&y.cameras.push(Ze)}const He=s.enabledFeatures;if(He&&He.includes("depth-sensing")){const Ge=h.getDepthInformation(ve[0]);Ge&&Ge.isValid&&Ge.texture&&v.init(e,Ge,s.renderState)}}for(let ve=0;ve<T.length;ve++){const le=M[ve],He=T[ve];le!==null&&He!==void 0&&He.update(le,ce,c||o)}_e&&_e(re,ce),ce.detectedPlanes&&n.dispatchEvent({type:"planesdetected",data:ce}),_=null}const ge=new yp;ge.setAnimationLoop(ye),this.setAnimationLoop=function(re){_e=re},this.dispose=function(){}}}const vs=new Si,dR=new Bt;function fR(i,e){function t(p,f){p.matrixAutoUpdate===!0&&p.updateMatrix(),f.value.copy(p.matrix)}function n(p,f){f.color.getRGB(p.fogColor.value,xp(i)),f.isFog?(p.fogNear.value=f.near,p.fogFar.value=f.far):f.isFogExp2&&(p.fogDensity.value=f.density)}function s(p,f,E,T,M){f.isMeshBasicMaterial||f.isMeshLambertMaterial?r(p,f):f.isMeshToonMaterial?(r(p,f),h(p,f)):f.isMeshPhongMaterial?(r(p,f),u(p,f)):f.isMeshStandardMaterial?(r(p,f),d(p,f),f.isMeshPhysicalMaterial&&m(p,f,M)):f.isMeshMatcapMaterial?(r(p,f),_(p,f)):f.isMeshDepthMaterial?r(p,f):f.isMeshDistanceMaterial?(r(p,f),v(p,f)):f.isMeshNormalMaterial?r(p,f):f.isLineBasicMaterial?(o(p,f),f.isLineDashedMaterial&&a(p,f)):f.isPointsMaterial?l(p,f,E,T):f.isSpriteMaterial?c(p,f):f.isShadowMaterial?(p.color.value.copy(f.color),p.opacity.value=f.opacity):f.isShaderMaterial&&(f.uniformsNeedUpdate=!1)}function r(p,f){p.opacity.value=f.opacity,f.color&&p.diffuse.value.copy(f.color),f.emissive&&p.emissive.value.copy(f.emissive).multiplyScalar(f.emissiveIntensity),f.map&&(p.map.value=f.map,t(f.map,p.mapTransform)),f.alphaMap&&(p.alphaMap.value=f.alphaMap,t(f.alphaMap,p.alphaMapTransform)),f.bumpMap&&(p.bumpMap.value=f.bumpMap,t(f.bumpMap,p.bumpMapTransform),p.bumpScale.value=f.bumpScale,f.side===An&&(p.bumpScale.value*=-1)),f.normalMap&&(p.normalMap.value=f.normalMap,t(f.normalMap,p.normalMapTransform),p.normalScale.value.copy(f.normalScale),f.side===An&&p.normalScale.value.negate()),f.displacementMap&&(p.displacementMap.value=f.displacementMap,t(f.displacementMap,p.displacementMapTransform),p.displacementScale.value=f.displacementScale,p.displacementBias.value=f.displacementBias),f.emissiveMap&&(p.emissiveMap.value=f.emissiveMap,t(f.emissiveMap,p.emissiveMapTransform)),f.specularMap&&(p.specularMap.value=f.specularMap,t(f.specularMap,p.specularMapTransform)),f.alphaTest>0&&(p.alphaTest.value=f.alphaTest);const E=e.get(f),T=E.envMap,M=E.envMapRotation;T&&(p.envMap.value=T,vs.copy(M),vs.x*=-1,vs.y*=-1,vs.z*=-1,T.isCubeTexture&&T.isRenderTargetTexture===!1&&(vs.y*=-1,vs.z*=-1),p.envMapRotation.value.setFromMatrix4(dR.makeRotationFromEuler(vs)),p.flipEnvMap.value=T.isCubeTexture&&T.isRenderTargetTexture===!1?-1:1,p.reflectivity.value=f.reflectivity,p.ior.value=f.ior,p.refractionRatio.value=f.refractionRatio),f.lightMap&&(p.lightMap.value=f.lightMap,p.lightMapIntensity.value=f.lightMapIntensity,t(f.lightMap,p.lightMapTransform)),f.aoMap&&(p.aoMap.value=f.aoMap,p.aoMapIntensity.value=f.aoMapIntensity,t(f.aoMap,p.aoMapTransform))}function o(p,f){p.diffuse.value.copy(f.color),p.opacity.value=f.opacity,f.map&&(p.map.value=f.map,t(f.map,p.mapTransform))}function a(p,f){p.dashSize.value=f.dashSize,p.totalSize.value=f.dashSize+f.gapSize,p.scale.value=f.scale}function l(p,f,E,T){p.diffuse.value.copy(f.color),p.opacity.value=f.opacity,p.size.value=f.size*E,p.scale.value=T*.5,f.map&&(p.map.value=f.map,t(f.map,p.uvTransform)),f.alphaMap&&(p.alphaMap.value=f.alphaMap,t(f.alphaMap,p.alphaMapTransform)),f.alphaTest>0&&(p.alphaTest.value=f.alphaTest)}function c(p,f){p.diffuse.value.copy(f.color),p.opacity.value=f.opacity,p.rotation.value=f.rotation,f.map&&(p.map.value=f.map,t(f.map,p.mapTransform)),f.alphaMap&&(p.alphaMap.value=f.alphaMap,t(f.alphaMap,p.alphaMapTransform)),f.alphaTest>0&&(p.alphaTest.value=f.alphaTest)}function u(p,f){p.specular.value.copy(f.specular),p.shininess.value=Math.max(f.shininess,1e-4)}function h(p,f){f.gradientMap&&(p.gradientMap.value=f.gradientMap)}function d(p,f){p.metalness.value=f.metalness,f.metalnessMap&&(p.metalnessMap.value=f.metalnessMap,t(f.metalnessMap,p.metalnessMapTransform)),p.roughness.value=f.roughness,f.roughnessMap&&(p.roughnessMap.value=f.roughnessMap,t(f.roughnessMap,p.roughnessMapTransform)),f.envMap&&(p.envMapIntensity.value=f.envMapIntensity)}function m(p,f,E){p.ior.value=f.ior,f.sheen>0&&(p.sheenColor.value.copy(f.sheenColor).multiplyScalar(f.sheen),p.sheenRoughness.value=f.sheenRoughness,f.sheenColorMap&&(p.sheenColorMap.value=f.sheenColorMap,t(f.sheenColorMap,p.sheenColorMapTransform)),f.sheenRoughnessMap&&(p.sheenRoughnessMap.value=f.sheenRoughnessMap,t(f.sheenRoughnessMap,p.sheenRoughnessMapTransform))),f.clearcoat>0&&(p.clearcoat.value=f.clearcoat,p.clearcoatRoughness.value=f.clearcoatRoughness,f.clearcoatMap&&(p.clearcoatMap.value=f.clearcoatMap,t(f.clearcoatMap,p.clearcoatMapTransform)),f.clearcoatRoughnessMap&&(p.clearcoatRoughnessMap.value=f.clearcoatRoughnessMap,t(f.clearcoatRoughnessMap,p.clearcoatRoughnessMapTransform)),f.clearcoatNormalMap&&(p.clearcoatNormalMap.value=f.clearcoatNormalMap,t(f.clearcoatNormalMap,p.clearcoatNormalMapTransform),p.clearcoatNormalScale.value.copy(f.clearcoatNormalScale),f.side===An&&p.clearcoatNormalScale.value.negate())),f.dispersion>0&&(p.dispersion.value=f.dispersion),f.iridescence>0&&(p.iridescence.value=f.iridescence,p.iridescenceIOR.value=f.iridescenceIOR,p.iridescenceThicknessMinimum.value=f.iridescenceThicknessRange[0],p.iridescenceThicknessMaximum.value=f.iridescenceThicknessRange[1],f.iridescenceMap&&(p.iridescenceMap.value=f.iridescenceMap,t(f.iridescenceMap,p.iridescenceMapTransform)),f.iridescenceThicknessMap&&(p.iridescenceThicknessMap.value=f.iridescenceThicknessMap,t(f.iridescenceThicknessMap,p.iridescenceThicknessMapTransform))),f.transmission>0&&(p.transmission.value=f.transmission,p.transmissionSamplerMap.value=E.texture,p.transmissionSamplerSize.value.set(E.width,E.height),f.transmissionMap&&(p.transmissionMap.value=f.transmissionMap,t(f.transmissionMap,p.transmissionMapTransform)),p.thickness.value=f.thickness,f.thicknessMap&&(p.thicknessMap.value=f.thicknessMap,t(f.thicknessMap,p.thicknessMapTransform)),p.attenuationDistance.value=f.attenuationDistance,p.attenuationColor.value.copy(f.attenuationColor)),f.anisotropy>0&&(p.anisotropyVector.value.set(f.anisotropy*Math.cos(f.anisotropyRotation),f.anisotropy*Math.sin(f.anisotropyRotation)),f.anisotropyMap&&(p.anisotropyMap.value=f.anisotropyMap,t(f.anisotropyMap,p.anisotropyMapTransform))),p.specularIntensity.value=f.specularIntensity,p.specularColor.value.copy(f.specularColor),f.specularColorMap&&(p.specularColorMap.value=f.specularColorMap,t(f.specularColorMap,p.specularColorMapTransform)),f.specularIntensityMap&&(p.specularIntensityMap.value=f.specularIntensityMap,t(f.specularIntensityMap,p.specularIntensityMapTransform))}function _(p,f){f.matcap&&(p.matcap.value=f.matcap)}function v(p,f){const E=e.get(f).light;p.referencePosition.value.setFromMatrixPosition(E.matrixWorld),p.nearDistance.value=E.shadow.camera.near,p.farDistance.value=E.shadow.camera.far}return{refreshFogUniforms:n,refreshMaterialUniforms:s}}function pR(i,e,t,n){let s={},r={},o=[];const a=i.getParameter(i.MAX_UNIFORM_BUFFER_BINDINGS);function l(E,T){const M=T.program;n.uniformBlockBinding(E,M)}function c(E,T){let M=s[E.id];M===void 0&&(_(E),M=u(E),s[E.id]=M,E.addEventListener("dispose",p));const k=T.program;n.updateUBOMapping(E,k);const L=e.render.frame;r[E.id]!==L&&(d(E),r[E.id]=L)}function u(E){const T=h();E.__bindingPointIndex=T;const M=i.createBuffer(),k=E.__size,L=E.usage;return i.bindBuffer(i.UNIFORM_BUFFER,M),i.bufferData(i.UNIFORM_BUFFER,k,L),i.bindBuffer(i.UNIFORM_BUFFER,null),i.bindBufferBase(i.UNIFORM_BUFFER,T,M),M}function h(){for(let E=0;E<a;E++)if(o.indexOf(E)===-1)return o.push(E),E;return console.error("THREE.WebGLRenderer: Maximum number of simultaneously usable uniforms groups reached."),0}function d(E){const T=s[E.id],M=E.uniforms,k=E.__cache;i.bindBuffer(i.UNIFORM_BUFFER,T);for(let L=0,D=M.length;L<D;L++){const N=Array.isArray(M[L])?M[L]:[M[L]];for(let w=0,y=N.length;w<y;w++){const R=N[w];if(m(R,L,w,k)===!0){const V=R.__offset,U=Array.isArray(R.value)?R.value:[R.value];let K=0;for(let X=0;X<U.length;X++){const Q=U[X],J=v(Q);typeof Q=="number"||typeof Q=="boolean"?(R.__data[0]=Q,i.bufferSubData(i.UNIFORM_BUFFER,V+K,R.__data)):Q.isMatrix3?(R.__data[0]=Q.elements[0],R.__data[1]=Q.elements[1],R.__data[2]=Q.elements[2],R.__data[3]=0,R.__data[4]=Q.elements[3],R.__data[5]=Q.elements[4],R.__data[6]=Q.elements[5],R.__data[7]=0,R.__data[8]=Q.elements[6],R.__data[9]=Q.elements[7],R.__data[10]=Q.elements[8],R.__data[11]=0):(Q.toArray(R.__data,K),K+=J.storage/Float32Array.BYTES_PER_ELEMENT)}i.bufferSubData(i.UNIFORM_BUFFER,V,R.__data)}}}i.bindBuffer(i.UNIFORM_BUFFER,null)}function m(E,T,M,k){const L=E.value,D=T+"_"+M;if(k[D]===void 0)return typeof L=="number"||typeof L=="boolean"?k[D]=L:k[D]=L.clone(),!0;{const N=k[D];if(typeof L=="number"||typeof L=="boolean"){if(N!==L)return k[D]=L,!0}else if(N.equals(L)===!1)return N.copy(L),!0}return!1}function _(E){const T=E.uniforms;let M=0;const k=16;for(let D=0,N=T.length;D<N;D++){const w=Array.isArray(T[D])?T[D]:[T[D]];for(let y=0,R=w.length;y<R;y++){const V=w[y],U=Array.isArray(V.value)?V.value:[V.value];for(let K=0,X=U.length;K<X;K++){const Q=U[K],J=v(Q),ne=M%k,fe=ne%J.boundary,he=ne+fe;M+=fe,he!==0&&k-he<J.storage&&(M+=k-he),V.__data=new Float32Array(J.storage/Float32Array.BYTES_PER_ELEMENT),V.__offset=M,M+=J.storage}}}const L=M%k;return L>0&&(M+=k-L),E.__size=M,E.__cache={},this}function v(E){const T={boundary:0,storage:0};return typeof E=="number"||typeof E=="boolean"?(T.boundary=4,T.storage=4):E.isVector2?(T.boundary=8,T.storage=8):E.isVector3||E.isColor?(T.boundary=16,T.storage=12):E.isVector4?(T.boundary=16,T.storage=16):E.isMatrix3?(T.boundary=48,T.storage=48):E.isMatrix4?(T.boundary=64,T.storage=64):E.isTexture?console.warn("THREE.WebGLRenderer: Texture samplers can not be part of an uniforms group."):console.warn("THREE.WebGLRenderer: Unsupported uniform value type.",E),T}function p(E){const T=E.target;T.removeEventListener("dispose",p);const M=o.indexOf(T.__bindingPointIndex);o.splice(M,1),i.deleteBuffer(s[T.id]),delete s[T.id],delete r[T.id]}function f(){for(const E in s)i.deleteBuffer(s[E]);o=[],s={},r={}}return{bind:l,update:c,dispose:f}}class mR{constructor(e={}){const{canvas:t=iE(),context:n=null,depth:s=!0,stencil:r=!1,alpha:o=!1,antialias:a=!1,premultipliedAlpha:l=!0,preserveDrawingBuffer:c=!1,powerPreference:u="default",failIfMajorPerformanceCaveat:h=!1,reverseDepthBuffer:d=!1}=e;this.isWebGLRenderer=!0;let m;if(n!==null){if(typeof WebGLRenderingContext<"u"&&n instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");m=n.getContextAttributes().alpha}else m=o;const _=new Uint32Array(4),v=new Int32Array(4);let p=null,f=null;const E=[],T=[];this.domElement=t,this.debug={checkShaderErrors:!0,onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this._outputColorSpace=Un,this.toneMapping=is,this.toneMappingExposure=1;const M=this;let k=!1,L=0,D=0,N=null,w=-1,y=null;const R=new Gt,V=new Gt;let U=null;const K=new at(0);let X=0,Q=t.width,J=t.height,ne=1,fe=null,he=null;const _e=new Gt(0,0,Q,J),ye=new Gt(0,0,Q,J);let ge=!1;const re=new Mu;let ce=!1,ve=!1;const le=new Bt,He=new Bt,Ge=new Y,Fe=new Gt,lt={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0};let Ze=!1;function ct(){return N===null?ne:1}let z=n;function Yt(b,F){return t.getContext(b,F)}try{const b={alpha:!0,depth:s,stencil:r,antialias:a,premultipliedAlpha:l,preserveDrawingBuffer:c,powerPreference:u,failIfMajorPerformanceCaveat:h};if("setAttribute"in t&&t.setAttribute("data-engine",`three.js r${uu}`),t.addEventListener("webglcontextlost",ae,!1),t.addEventListener("webglcontextrestored",Re,!1),t.addEventListener("webglcontextcreationerror",Ce,!1),z===null){const F="webgl2";if(z=Yt(F,b),z===null)throw Yt(F)?new Error("Error creating WebGL context with your selected attributes."):new Error("Error creating WebGL context.")}}catch(b){throw console.error("THREE.WebGLRenderer: "+b.message),b}let Qe,tt,We,ht,De,C,S,Z,ee,G,ie,be,xe,Ae,Ke,pe,Me,Oe,Be,we,it,Ye,dt,O;function Se(){Qe=new MT(z),Qe.init(),Ye=new rR(z,Qe),tt=new pT(z,Qe,e,Ye),We=new nR(z,Qe),tt.reverseDepthBuffer&&d&&We.buffers.depth.setReversed(!0),ht=new bT(z),De=new HA,C=new sR(z,Qe,We,De,tt,Ye,ht),S=new gT(M),Z=new xT(M),ee=new PE(z),dt=new dT(z,ee),G=new ST(z,ee,ht,dt),ie=new wT(z,G,ee,ht),Be=new ET(z,tt,C),pe=new mT(De),be=new zA(M,S,Z,Qe,tt,dt,pe),xe=new fR(M,De),Ae=new GA,Ke=new jA(Qe),Oe=new hT(M,S,Z,We,ie,m,l),Me=new eR(M,ie,tt),O=new pR(z,ht,tt,We),we=new fT(z,Qe,ht),it=new yT(z,Qe,ht),ht.programs=be.programs,M.capabilities=tt,M.extensions=Qe,M.properties=De,M.renderLists=Ae,M.shadowMap=Me,M.state=We,M.info=ht}Se();const se=new hR(M,z);this.xr=se,this.getContext=function(){return z},this.getContextAttributes=function(){return z.getContextAttributes()},this.forceContextLoss=function(){const b=Qe.get("WEBGL_lose_context");b&&b.loseContext()},this.forceContextRestore=function(){const b=Qe.get("WEBGL_lose_context");b&&b.restoreContext()},this.getPixelRatio=function(){return ne},this.setPixelRatio=function(b){b!==void 0&&(ne=b,this.setSize(Q,J,!1))},this.getSize=function(b){return b.set(Q,J)},this.setSize=function(b,F,$=!0){if(se.isPresenting){console.warn("THREE.WebGLRenderer: Can't change size while VR device is presenting.");return}Q=b,J=F,t.width=Math.floor(b*ne),t.height=Math.floor(F*ne),$===!0&&(t.style.width=b+"px",t.style.height=F+"px"),this.setViewport(0,0,b,F)},this.getDrawingBufferSize=function(b){return b.set(Q*ne,J*ne).floor()},this.setDrawingBufferSize=function(b,F,$){Q=b,J=F,ne=$,t.width=Math.floor(b*$),t.height=Math.floor(F*$),this.setViewport(0,0,b,F)},this.getCurrentViewport=function(b){return b.copy(R)},this.getViewport=function(b){return b.copy(_e)},this.setViewport=function(b,F,$,q){b.isVector4?_e.set(b.x,b.y,b.z,b.w):_e.set(b,F,$,q),We.viewport(R.copy(_e).multiplyScalar(ne).round())},this.getScissor=function(b){return b.copy(ye)},this.setScissor=function(b,F,$,q){b.isVector4?ye.set(b.x,b.y,b.z,b.w):ye.set(b,F,$,q),We.scissor(V.copy(ye).multiplyScalar(ne).round())},this.getScissorTest=function(){return ge},this.setScissorTest=function(b){We.setScissorTest(ge=b)},this.setOpaqueSort=function(b){fe=b},this.setTransparentSort=function(b){he=b},this.getClearColor=function(b){return b.copy(Oe.getClearColor())},this.setClearColor=function(){Oe.setClearColor.apply(Oe,arguments)},this.getClearAlpha=function(){return Oe.getClearAlpha()},this.setClearAlpha=function(){Oe.setClearAlpha.apply(Oe,arguments)},this.clear=function(b=!0,F=!0,$=!0){let q=0;if(b){let H=!1;if(N!==null){const de=N.texture.format;H=de===gu||de===mu||de===pu}if(H){const de=N.texture.type,Ee=de===Bi||de===Us||de===po||de===Rr||de===du||de===fu,ke=Oe.getClearColor(),Ie=Oe.getClearAlpha(),$e=ke.r,qe=ke.g,Ue=ke.b;Ee?(_[0]=$e,_[1]=qe,_[2]=Ue,_[3]=Ie,z.clearBufferuiv(z.COLOR,0,_)):(v[0]=$e,v[1]=qe,v[2]=Ue,v[3]=Ie,z.clearBufferiv(z.COLOR,0,v))}else q|=z.COLOR_BUFFER_BIT}F&&(q|=z.DEPTH_BUFFER_BIT),$&&(q|=z.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),z.clear(q)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.dispose=function(){t.removeEventListener("webglcontextlost",ae,!1),t.removeEventListener("webglcontextrestored",Re,!1),t.removeEventListener("webglcontextcreationerror",Ce,!1),Ae.dispose(),Ke.dispose(),De.dispose(),S.dispose(),Z.dispose(),ie.dispose(),dt.dispose(),O.dispose(),be.dispose(),se.dispose(),se.removeEventListener("sessionstart",Rn),se.removeEventListener("sessionend",bi),bn.stop()};function ae(b){b.preventDefault(),console.log("THREE.WebGLRenderer: Context Lost."),k=!0}function Re(){console.log("THREE.WebGLRenderer: Context Restored."),k=!1;const b=ht.autoReset,F=Me.enabled,$=Me.autoUpdate,q=Me.needsUpdate,H=Me.type;Se(),ht.autoReset=b,Me.enabled=F,Me.autoUpdate=$,Me.needsUpdate=q,Me.type=H}function Ce(b){console.error("THREE.WebGLRenderer: A WebGL context could not be created. Reason: ",b.statusMessage)}function Je(b){const F=b.target;F.removeEventListener("dispose",Je),Ft(F)}function Ft(b){tn(b),De.remove(b)}function tn(b){const F=De.get(b).programs;F!==void 0&&(F.forEach(function($){be.releaseProgram($)}),b.isShaderMaterial&&be.releaseShaderCache(b))}this.renderBufferDirect=function(b,F,$,q,H,de){F===null&&(F=lt);const Ee=H.isMesh&&H.matrixWorld.determinant()<0,ke=Va(b,F,$,q,H);We.setMaterial(q,Ee);let Ie=$.index,$e=1;if(q.wireframe===!0){if(Ie=G.getWireframeAttribute($),Ie===void 0)return;$e=2}const qe=$.drawRange,Ue=$.attributes.position;let rt=qe.start*$e,bt=(qe.start+qe.count)*$e;de!==null&&(rt=Math.max(rt,de.start*$e),bt=Math.min(bt,(de.start+de.count)*$e)),Ie!==null?(rt=Math.max(rt,0),bt=Math.min(bt,Ie.count)):Ue!=null&&(rt=Math.max(rt,0),bt=Math.min(bt,Ue.count));const wt=bt-rt;if(wt<0||wt===1/0)return;dt.setup(H,q,ke,$,Ie);let nn,ut=we;if(Ie!==null&&(nn=ee.get(Ie),ut=it,ut.setIndex(nn)),H.isMesh)q.wireframe===!0?(We.setLineWidth(q.wireframeLinewidth*ct()),ut.setMode(z.LINES)):ut.setMode(z.TRIANGLES);else if(H.isLine){let ze=q.linewidth;ze===void 0&&(ze=1),We.setLineWidth(ze*ct()),H.isLineSegments?ut.setMode(z.LINES):H.isLineLoop?ut.setMode(z.LINE_LOOP):ut.setMode(z.LINE_STRIP)}else H.isPoints?ut.setMode(z.POINTS):H.isSprite&&ut.setMode(z.TRIANGLES);if(H.isBatchedMesh)if(H._multiDrawInstances!==null)ut.renderMultiDrawInstances(H._multiDrawStarts,H._multiDrawCounts,H._multiDrawCount,H._multiDrawInstances);else if(Qe.get("WEBGL_multi_draw"))ut.renderMultiDraw(H._multiDrawStarts,H._multiDrawCounts,H._multiDrawCount);else{const ze=H._multiDrawStarts,Ot=H._multiDrawCounts,ft=H._multiDrawCount,En=Ie?ee.get(Ie).bytesPerElement:1,ci=De.get(q).currentProgram.getUniforms();for(let hn=0;hn<ft;hn++)ci.setValue(z,"_gl_DrawID",hn),ut.render(ze[hn]/En,Ot[hn])}else if(H.isInstancedMesh)ut.renderInstances(rt,wt,H.count);else if($.isInstancedBufferGeometry){const ze=$._maxInstanceCount!==void 0?$._maxInstanceCount:1/0,Ot=Math.min($.instanceCount,ze);ut.renderInstances(rt,wt,Ot)}else ut.render(rt,wt)};function Mt(b,F,$){b.transparent===!0&&b.side===Ni&&b.forceSinglePass===!1?(b.side=An,b.needsUpdate=!0,zs(b,F,$),b.side=rs,b.needsUpdate=!0,zs(b,F,$),b.side=Ni):zs(b,F,$)}this.compile=function(b,F,$=null){$===null&&($=b),f=Ke.get($),f.init(F),T.push(f),$.traverseVisible(function(H){H.isLight&&H.layers.test(F.layers)&&(f.pushLight(H),H.castShadow&&f.pushShadow(H))}),b!==$&&b.traverseVisible(function(H){H.isLight&&H.layers.test(F.layers)&&(f.pushLight(H),H.castShadow&&f.pushShadow(H))}),f.setupLights();const q=new Set;return b.traverse(function(H){if(!(H.isMesh||H.isPoints||H.isLine||H.isSprite))return;const de=H.material;if(de)if(Array.isArray(de))for(let Ee=0;Ee<de.length;Ee++){const ke=de[Ee];Mt(ke,$,H),q.add(ke)}else Mt(de,$,H),q.add(de)}),T.pop(),f=null,q},this.compileAsync=function(b,F,$=null){const q=this.compile(b,F,$);return new Promise(H=>{function de(){if(q.forEach(function(Ee){De.get(Ee).currentProgram.isReady()&&q.delete(Ee)}),q.size===0){H(b);return}setTimeout(de,10)}Qe.get("KHR_parallel_shader_compile")!==null?de():setTimeout(de,10)})};let jt=null;function Lt(b){jt&&jt(b)}function Rn(){bn.stop()}function bi(){bn.start()}const bn=new yp;bn.setAnimationLoop(Lt),typeof self<"u"&&bn.setContext(self),this.setAnimationLoop=function(b){jt=b,se.setAnimationLoop(b),b===null?bn.stop():bn.start()},se.addEventListener("sessionstart",Rn),se.addEventListener("sessionend",bi),this.render=function(b,F){if(F!==void 0&&F.isCamera!==!0){console.error("THREE.WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(k===!0)return;if(b.matrixWorldAutoUpdate===!0&&b.updateMatrixWorld(),F.parent===null&&F.matrixWorldAutoUpdate===!0&&F.updateMatrixWorld(),se.enabled===!0&&se.isPresenting===!0&&(se.cameraAutoUpdate===!0&&se.updateCamera(F),F=se.getCamera()),b.isScene===!0&&b.onBeforeRender(M,b,F,N),f=Ke.get(b,T.length),f.init(F),T.push(f),He.multiplyMatrices(F.projectionMatrix,F.matrixWorldInverse),re.setFromProjectionMatrix(He),ve=this.localClippingEnabled,ce=pe.init(this.clippingPlanes,ve),p=Ae.get(b,E.length),p.init(),E.push(p),se.enabled===!0&&se.isPresenting===!0){const de=M.xr.getDepthSensingMesh();de!==null&&un(de,F,-1/0,M.sortObjects)}un(b,F,0,M.sortObjects),p.finish(),M.sortObjects===!0&&p.sort(fe,he),Ze=se.enabled===!1||se.isPresenting===!1||se.hasDepthSensing()===!1,Ze&&Oe.addToRenderList(p,b),this.info.render.frame++,ce===!0&&pe.beginShadows();const $=f.state.shadowsArray;Me.render($,b,F),ce===!0&&pe.endShadows(),this.info.autoReset===!0&&this.info.reset();const q=p.opaque,H=p.transmissive;if(f.setupLights(),F.isArrayCamera){const de=F.cameras;if(H.length>0)for(let Ee=0,ke=de.length;Ee<ke;Ee++){const Ie=de[Ee];wi(q,H,b,Ie)}Ze&&Oe.render(b);for(let Ee=0,ke=de.length;Ee<ke;Ee++){const Ie=de[Ee];Ei(p,b,Ie,Ie.viewport)}}else H.length>0&&wi(q,H,b,F),Ze&&Oe.render(b),Ei(p,b,F);N!==null&&(C.updateMultisampleRenderTarget(N),C.updateRenderTargetMipmap(N)),b.isScene===!0&&b.onAfterRender(M,b,F),dt.resetDefaultState(),w=-1,y=null,T.pop(),T.length>0?(f=T[T.length-1],ce===!0&&pe.setGlobalState(M.clippingPlanes,f.state.camera)):f=null,E.pop(),E.length>0?p=E[E.length-1]:p=null};function un(b,F,$,q){if(b.visible===!1)return;if(b.layers.test(F.layers)){if(b.isGroup)$=b.renderOrder;else if(b.isLOD)b.autoUpdate===!0&&b.update(F);else if(b.isLight)f.pushLight(b),b.castShadow&&f.pushShadow(b);else if(b.isSprite){if(!b.frustumCulled||re.intersectsSprite(b)){q&&Fe.setFromMatrixPosition(b.matrixWorld).applyMatrix4(He);const Ee=ie.update(b),ke=b.material;ke.visible&&p.push(b,Ee,ke,$,Fe.z,null)}}else if((b.isMesh||b.isLine||b.isPoints)&&(!b.frustumCulled||re.intersectsObject(b))){const Ee=ie.update(b),ke=b.material;if(q&&(b.boundingSphere!==void 0?(b.boundingSphere===null&&b.computeBoundingSphere(),Fe.copy(b.boundingSphere.center)):(Ee.boundingSphere===null&&Ee.computeBoundingSphere(),Fe.copy(Ee.boundingSphere.center)),Fe.applyMatrix4(b.matrixWorld).applyMatrix4(He)),Array.isArray(ke)){const Ie=Ee.groups;for(let $e=0,qe=Ie.length;$e<qe;$e++){const Ue=Ie[$e],rt=ke[Ue.materialIndex];rt&&rt.visible&&p.push(b,Ee,rt,$,Fe.z,Ue)}}else ke.visible&&p.push(b,Ee,ke,$,Fe.z,null)}}const de=b.children;for(let Ee=0,ke=de.length;Ee<ke;Ee++)un(de[Ee],F,$,q)}function Ei(b,F,$,q){const H=b.opaque,de=b.transmissive,Ee=b.transparent;f.setupLightsView($),ce===!0&&pe.setGlobalState(M.clippingPlanes,$),q&&We.viewport(R.copy(q)),H.length>0&&as(H,F,$),de.length>0&&as(de,F,$),Ee.length>0&&as(Ee,F,$),We.buffers.depth.setTest(!0),We.buffers.depth.setMask(!0),We.buffers.color.setMask(!0),We.setPolygonOffset(!1)}function wi(b,F,$,q){if(($.isScene===!0?$.overrideMaterial:null)!==null)return;f.state.transmissionRenderTarget[q.id]===void 0&&(f.state.transmissionRenderTarget[q.id]=new Fs(1,1,{generateMipmaps:!0,type:Qe.has("EXT_color_buffer_half_float")||Qe.has("EXT_color_buffer_float")?vo:Bi,minFilter:Rs,samples:4,stencilBuffer:r,resolveDepthBuffer:!1,resolveStencilBuffer:!1,colorSpace:pt.workingColorSpace}));const de=f.state.transmissionRenderTarget[q.id],Ee=q.viewport||R;de.setSize(Ee.z,Ee.w);const ke=M.getRenderTarget();M.setRenderTarget(de),M.getClearColor(K),X=M.getClearAlpha(),X<1&&M.setClearColor(16777215,.5),M.clear(),Ze&&Oe.render($);const Ie=M.toneMapping;M.toneMapping=is;const $e=q.viewport;if(q.viewport!==void 0&&(q.viewport=void 0),f.setupLightsView(q),ce===!0&&pe.setGlobalState(M.clippingPlanes,q),as(b,$,q),C.updateMultisampleRenderTarget(de),C.updateRenderTargetMipmap(de),Qe.has("WEBGL_multisampled_render_to_texture")===!1){let qe=!1;for(let Ue=0,rt=F.length;Ue<rt;Ue++){const bt=F[Ue],wt=bt.object,nn=bt.geometry,ut=bt.material,ze=bt.group;if(ut.side===Ni&&wt.layers.test(q.layers)){const Ot=ut.side;ut.side=An,ut.needsUpdate=!0,zr(wt,$,q,nn,ut,ze),ut.side=Ot,ut.needsUpdate=!0,qe=!0}}qe===!0&&(C.updateMultisampleRenderTarget(de),C.updateRenderTargetMipmap(de))}M.setRenderTarget(ke),M.setClearColor(K,X),$e!==void 0&&(q.viewport=$e),M.toneMapping=Ie}function as(b,F,$){const q=F.isScene===!0?F.overrideMaterial:null;for(let H=0,de=b.length;H<de;H++){const Ee=b[H],ke=Ee.object,Ie=Ee.geometry,$e=q===null?Ee.material:q,qe=Ee.group;ke.layers.test($.layers)&&zr(ke,F,$,Ie,$e,qe)}}function zr(b,F,$,q,H,de){b.onBeforeRender(M,F,$,q,H,de),b.modelViewMatrix.multiplyMatrices($.matrixWorldInverse,b.matrixWorld),b.normalMatrix.getNormalMatrix(b.modelViewMatrix),H.onBeforeRender(M,F,$,q,b,de),H.transparent===!0&&H.side===Ni&&H.forceSinglePass===!1?(H.side=An,H.needsUpdate=!0,M.renderBufferDirect($,F,q,H,b,de),H.side=rs,H.needsUpdate=!0,M.renderBufferDirect($,F,q,H,b,de),H.side=Ni):M.renderBufferDirect($,F,q,H,b,de),b.onAfterRender(M,F,$,q,H,de)}function zs(b,F,$){F.isScene!==!0&&(F=lt);const q=De.get(b),H=f.state.lights,de=f.state.shadowsArray,Ee=H.state.version,ke=be.getParameters(b,H.state,de,F,$),Ie=be.getProgramCacheKey(ke);let $e=q.programs;q.environment=b.isMeshStandardMaterial?F.environment:null,q.fog=F.fog,q.envMap=(b.isMeshStandardMaterial?Z:S).get(b.envMap||q.environment),q.envMapRotation=q.environment!==null&&b.envMap===null?F.environmentRotation:b.envMapRotation,$e===void 0&&(b.addEventListener("dispose",Je),$e=new Map,q.programs=$e);let qe=$e.get(Ie);if(qe!==void 0){if(q.currentProgram===qe&&q.lightsStateVersion===Ee)return li(b,ke),qe}else ke.uniforms=be.getUniforms(b),b.onBeforeCompile(ke,M),qe=be.acquireProgram(ke,Ie),$e.set(Ie,qe),q.uniforms=ke.uniforms;const Ue=q.uniforms;return(!b.isShaderMaterial&&!b.isRawShaderMaterial||b.clipping===!0)&&(Ue.clippingPlanes=pe.uniform),li(b,ke),q.needsLights=Eo(b),q.lightsStateVersion=Ee,q.needsLights&&(Ue.ambientLightColor.value=H.state.ambient,Ue.lightProbe.value=H.state.probe,Ue.directionalLights.value=H.state.directional,Ue.directionalLightShadows.value=H.state.directionalShadow,Ue.spotLights.value=H.state.spot,Ue.spotLightShadows.value=H.state.spotShadow,Ue.rectAreaLights.value=H.state.rectArea,Ue.ltc_1.value=H.state.rectAreaLTC1,Ue.ltc_2.value=H.state.rectAreaLTC2,Ue.pointLights.value=H.state.point,Ue.pointLightShadows.value=H.state.pointShadow,Ue.hemisphereLights.value=H.state.hemi,Ue.directionalShadowMap.value=H.state.directionalShadowMap,Ue.directionalShadowMatrix.value=H.state.directionalShadowMatrix,Ue.spotShadowMap.value=H.state.spotShadowMap,Ue.spotLightMatrix.value=H.state.spotLightMatrix,Ue.spotLightMap.value=H.state.spotLightMap,Ue.pointShadowMap.value=H.state.pointShadowMap,Ue.pointShadowMatrix.value=H.state.pointShadowMatrix),q.currentProgram=qe,q.uniformsList=null,qe}function bo(b){if(b.uniformsList===null){const F=b.currentProgram.getUniforms();b.uniformsList=pa.seqWithValue(F.seq,b.uniforms)}return b.uniformsList}function li(b,F){const $=De.get(b);$.outputColorSpace=F.outputColorSpace,$.batching=F.batching,$.batchingColor=F.batchingColor,$.instancing=F.instancing,$.instancingColor=F.instancingColor,$.instancingMorph=F.instancingMorph,$.skinning=F.skinning,$.morphTargets=F.morphTargets,$.morphNormals=F.morphNormals,$.morphColors=F.morphColors,$.morphTargetsCount=F.morphTargetsCount,$.numClippingPlanes=F.numClippingPlanes,$.numIntersection=F.numClipIntersection,$.vertexAlphas=F.vertexAlphas,$.vertexTangents=F.vertexTangents,$.toneMapping=F.toneMapping}function Va(b,F,$,q,H){F.isScene!==!0&&(F=lt),C.resetTextureUnits();const de=F.fog,Ee=q.isMeshStandardMaterial?F.environment:null,ke=N===null?M.outputColorSpace:N.isXRRenderTarget===!0?N.texture.colorSpace:Ur,Ie=(q.isMeshStandardMaterial?Z:S).get(q.envMap||Ee),$e=q.vertexColors===!0&&!!$.attributes.color&&$.attributes.color.itemSize===4,qe=!!$.attributes.tangent&&(!!q.normalMap||q.anisotropy>0),Ue=!!$.morphAttributes.position,rt=!!$.morphAttributes.normal,bt=!!$.morphAttributes.color;let wt=is;q.toneMapped&&(N===null||N.isXRRenderTarget===!0)&&(wt=M.toneMapping);const nn=$.morphAttributes.position||$.morphAttributes.normal||$.morphAttributes.color,ut=nn!==void 0?nn.length:0,ze=De.get(q),Ot=f.state.lights;if(ce===!0&&(ve===!0||b!==y)){const gn=b===y&&q.id===w;pe.setState(q,b,gn)}let ft=!1;q.version===ze.__version?(ze.needsLights&&ze.lightsStateVersion!==Ot.state.version||ze.outputColorSpace!==ke||H.isBatchedMesh&&ze.batching===!1||!H.isBatchedMesh&&ze.batching===!0||H.isBatchedMesh&&ze.batchingColor===!0&&H.colorTexture===null||H.isBatchedMesh&&ze.batchingColor===!1&&H.colorTexture!==null||H.isInstancedMesh&&ze.instancing===!1||!H.isInstancedMesh&&ze.instancing===!0||H.isSkinnedMesh&&ze.skinning===!1||!H.isSkinnedMesh&&ze.skinning===!0||H.isInstancedMesh&&ze.instancingColor===!0&&H.instanceColor===null||H.isInstancedMesh&&ze.instancingColor===!1&&H.instanceColor!==null||H.isInstancedMesh&&ze.instancingMorph===!0&&H.morphTexture===null||H.isInstancedMesh&&ze.instancingMorph===!1&&H.morphTexture!==null||ze.envMap!==Ie||q.fog===!0&&ze.fog!==de||ze.numClippingPlanes!==void 0&&(ze.numClippingPlanes!==pe.numPlanes||ze.numIntersection!==pe.numIntersection)||ze.vertexAlphas!==$e||ze.vertexTangents!==qe||ze.morphTargets!==Ue||ze.morphNormals!==rt||ze.morphColors!==bt||ze.toneMapping!==wt||ze.morphTargetsCount!==ut)&&(ft=!0):(ft=!0,ze.__version=q.version);let En=ze.currentProgram;ft===!0&&(En=zs(q,F,H));let ci=!1,hn=!1,cs=!1;const Rt=En.getUniforms(),Bn=ze.uniforms;if(We.useProgram(En.program)&&(ci=!0,hn=!0,cs=!0),q.id!==w&&(w=q.id,hn=!0),ci||y!==b){We.buffers.depth.getReversed()?(le.copy(b.projectionMatrix),rE(le),oE(le),Rt.setValue(z,"projectionMatrix",le)):Rt.setValue(z,"projectionMatrix",b.projectionMatrix),Rt.setValue(z,"viewMatrix",b.matrixWorldInverse);const ui=Rt.map.cameraPosition;ui!==void 0&&ui.setValue(z,Ge.setFromMatrixPosition(b.matrixWorld)),tt.logarithmicDepthBuffer&&Rt.setValue(z,"logDepthBufFC",2/(Math.log(b.far+1)/Math.LN2)),(q.isMeshPhongMaterial||q.isMeshToonMaterial||q.isMeshLambertMaterial||q.isMeshBasicMaterial||q.isMeshStandardMaterial||q.isShaderMaterial)&&Rt.setValue(z,"isOrthographic",b.isOrthographicCamera===!0),y!==b&&(y=b,hn=!0,cs=!0)}if(H.isSkinnedMesh){Rt.setOptional(z,H,"bindMatrix"),Rt.setOptional(z,H,"bindMatrixInverse");const gn=H.skeleton;gn&&(gn.boneTexture===null&&gn.computeBoneTexture(),Rt.setValue(z,"boneTexture",gn.boneTexture,C))}H.isBatchedMesh&&(Rt.setOptional(z,H,"batchingTexture"),Rt.setValue(z,"batchingTexture",H._matricesTexture,C),Rt.setOptional(z,H,"batchingIdTexture"),Rt.setValue(z,"batchingIdTexture",H._indirectTexture,C),Rt.setOptional(z,H,"batchingColorTexture"),H._colorsTexture!==null&&Rt.setValue(z,"batchingColorTexture",H._colorsTexture,C));const zi=$.morphAttributes;if((zi.position!==void 0||zi.normal!==void 0||zi.color!==void 0)&&Be.update(H,$,En),(hn||ze.receiveShadow!==H.receiveShadow)&&(ze.receiveShadow=H.receiveShadow,Rt.setValue(z,"receiveShadow",H.receiveShadow)),q.isMeshGouraudMaterial&&q.envMap!==null&&(Bn.envMap.value=Ie,Bn.flipEnvMap.value=Ie.isCubeTexture&&Ie.isRenderTargetTexture===!1?-1:1),q.isMeshStandardMaterial&&q.envMap===null&&F.environment!==null&&(Bn.envMapIntensity.value=F.environmentIntensity),hn&&(Rt.setValue(z,"toneMappingExposure",M.toneMappingExposure),ze.needsLights&&ls(Bn,cs),de&&q.fog===!0&&xe.refreshFogUniforms(Bn,de),xe.refreshMaterialUniforms(Bn,q,ne,J,f.state.transmissionRenderTarget[b.id]),pa.upload(z,bo(ze),Bn,C)),q.isShaderMaterial&&q.uniformsNeedUpdate===!0&&(pa.upload(z,bo(ze),Bn,C),q.uniformsNeedUpdate=!1),q.isSpriteMaterial&&Rt.setValue(z,"center",H.center),Rt.setValue(z,"modelViewMatrix",H.modelViewMatrix),Rt.setValue(z,"normalMatrix",H.normalMatrix),Rt.setValue(z,"modelMatrix",H.matrixWorld),q.isShaderMaterial||q.isRawShaderMaterial){const gn=q.uniformsGroups;for(let ui=0,Yn=gn.length;ui<Yn;ui++){const Hs=gn[ui];O.update(Hs,En),O.bind(Hs,En)}}return En}function ls(b,F){b.ambientLightColor.needsUpdate=F,b.lightProbe.needsUpdate=F,b.directionalLights.needsUpdate=F,b.directionalLightShadows.needsUpdate=F,b.pointLights.needsUpdate=F,b.pointLightShadows.needsUpdate=F,b.spotLights.needsUpdate=F,b.spotLightShadows.needsUpdate=F,b.rectAreaLights.needsUpdate=F,b.hemisphereLights.needsUpdate=F}function Eo(b){return b.isMeshLambertMaterial||b.isMeshToonMaterial||b.isMeshPhongMaterial||b.isMeshStandardMaterial||b.isShadowMaterial||b.isShaderMaterial&&b.lights===!0}this.getActiveCubeFace=function(){return L},this.getActiveMipmapLevel=function(){return D},this.getRenderTarget=function(){return N},this.setRenderTargetTextures=function(b,F,$){De.get(b.texture).__webglTexture=F,De.get(b.depthTexture).__webglTexture=$;const q=De.get(b);q.__hasExternalTextures=!0,q.__autoAllocateDepthBuffer=$===void 0,q.__autoAllocateDepthBuffer||Qe.has("WEBGL_multisampled_render_to_texture")===!0&&(console.warn("THREE.WebGLRenderer: Render-to-texture extension was disabled because an external texture was provided"),q.__useRenderToTexture=!1)},this.setRenderTargetFramebuffer=function(b,F){const $=De.get(b);$.__webglFramebuffer=F,$.__useDefaultFramebuffer=F===void 0},this.setRenderTarget=function(b,F=0,$=0){N=b,L=F,D=$;let q=!0,H=null,de=!1,Ee=!1;if(b){const Ie=De.get(b);if(Ie.__useDefaultFramebuffer!==void 0)We.bindFramebuffer(z.FRAMEBUFFER,null),q=!1;else if(Ie.__webglFramebuffer===void 0)C.setupRenderTarget(b);else if(Ie.__hasExternalTextures)C.rebindTextures(b,De.get(b.texture).__webglTexture,De.get(b.depthTexture).__webglTexture);else if(b.depthBuffer){const Ue=b.depthTexture;if(Ie.__boundDepthTexture!==Ue){if(Ue!==null&&De.has(Ue)&&(b.width!==Ue.image.width||b.height!==Ue.image.height))throw new Error("WebGLRenderTarget: Attached DepthTexture is initialized to the incorrect size.");C.setupDepthRenderbuffer(b)}}const $e=b.texture;($e.isData3DTexture||$e.isDataArrayTexture||$e.isCompressedArrayTexture)&&(Ee=!0);const qe=De.get(b).__webglFramebuffer;b.isWebGLCubeRenderTarget?(Array.isArray(qe[F])?H=qe[F][$]:H=qe[F],de=!0):b.samples>0&&C.useMultisampledRTT(b)===!1?H=De.get(b).__webglMultisampledFramebuffer:Array.isArray(qe)?H=qe[$]:H=qe,R.copy(b.viewport),V.copy(b.scissor),U=b.scissorTest}else R.copy(_e).multiplyScalar(ne).floor(),V.copy(ye).multiplyScalar(ne).floor(),U=ge;if(We.bindFramebuffer(z.FRAMEBUFFER,H)&&q&&We.drawBuffers(b,H),We.viewport(R),We.scissor(V),We.setScissorTest(U),de){const Ie=De.get(b.texture);z.framebufferTexture2D(z.FRAMEBUFFER,z.COLOR_ATTACHMENT0,z.TEXTURE_CUBE_MAP_POSITIVE_X+F,Ie.__webglTexture,$)}else if(Ee){const Ie=De.get(b.texture),$e=F||0;z.framebufferTextureLayer(z.FRAMEBUFFER,z.COLOR_ATTACHMENT0,Ie.__webglTexture,$||0,$e)}w=-1},this.readRenderTargetPixels=function(b,F,$,q,H,de,Ee){if(!(b&&b.isWebGLRenderTarget)){console.error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let ke=De.get(b).__webglFramebuffer;if(b.isWebGLCubeRenderTarget&&Ee!==void 0&&(ke=ke[Ee]),ke){We.bindFramebuffer(z.FRAMEBUFFER,ke);try{const Ie=b.texture,$e=Ie.format,qe=Ie.type;if(!tt.textureFormatReadable($e)){console.error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(!tt.textureTypeReadable(qe)){console.error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}F>=0&&F<=b.width-q&&$>=0&&$<=b.height-H&&z.readPixels(F,$,q,H,Ye.convert($e),Ye.convert(qe),de)}finally{const Ie=N!==null?De.get(N).__webglFramebuffer:null;We.bindFramebuffer(z.FRAMEBUFFER,Ie)}}},this.readRenderTargetPixelsAsync=async function(b,F,$,q,H,de,Ee){if(!(b&&b.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let ke=De.get(b).__webglFramebuffer;if(b.isWebGLCubeRenderTarget&&Ee!==void 0&&(ke=ke[Ee]),ke){const Ie=b.texture,$e=Ie.format,qe=Ie.type;if(!tt.textureFormatReadable($e))throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(!tt.textureTypeReadable(qe))throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");if(F>=0&&F<=b.width-q&&$>=0&&$<=b.height-H){We.bindFramebuffer(z.FRAMEBUFFER,ke);const Ue=z.createBuffer();z.bindBuffer(z.PIXEL_PACK_BUFFER,Ue),z.bufferData(z.PIXEL_PACK_BUFFER,de.byteLength,z.STREAM_READ),z.readPixels(F,$,q,H,Ye.convert($e),Ye.convert(qe),0);const rt=N!==null?De.get(N).__webglFramebuffer:null;We.bindFramebuffer(z.FRAMEBUFFER,rt);const bt=z.fenceSync(z.SYNC_GPU_COMMANDS_COMPLETE,0);return z.flush(),await sE(z,bt,4),z.bindBuffer(z.PIXEL_PACK_BUFFER,Ue),z.getBufferSubData(z.PIXEL_PACK_BUFFER,0,de),z.deleteBuffer(Ue),z.deleteSync(bt),de}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")}},this.copyFramebufferToTexture=function(b,F=null,$=0){b.isTexture!==!0&&(ro("WebGLRenderer: copyFramebufferToTexture function signature has changed."),F=arguments[0]||null,b=arguments[1]);const q=Math.pow(2,-$),H=Math.floor(b.image.width*q),de=Math.floor(b.image.height*q),Ee=F!==null?F.x:0,ke=F!==null?F.y:0;C.setTexture2D(b,0),z.copyTexSubImage2D(z.TEXTURE_2D,$,0,0,Ee,ke,H,de),We.unbindTexture()},this.copyTextureToTexture=function(b,F,$=null,q=null,H=0){b.isTexture!==!0&&(ro("WebGLRenderer: copyTextureToTexture function signature has changed."),q=arguments[0]||null,b=arguments[1],F=arguments[2],H=arguments[3]||0,$=null);let de,Ee,ke,Ie,$e,qe,Ue,rt,bt;const wt=b.isCompressedTexture?b.mipmaps[H]:b.image;$!==null?(de=$.max.x-$.min.x,Ee=$.max.y-$.min.y,ke=$.isBox3?$.max.z-$.min.z:1,Ie=$.min.x,$e=$.min.y,qe=$.isBox3?$.min.z:0):(de=wt.width,Ee=wt.height,ke=wt.depth||1,Ie=0,$e=0,qe=0),q!==null?(Ue=q.x,rt=q.y,bt=q.z):(Ue=0,rt=0,bt=0);const nn=Ye.convert(F.format),ut=Ye.convert(F.type);let ze;F.isData3DTexture?(C.setTexture3D(F,0),ze=z.TEXTURE_3D):F.isDataArrayTexture||F.isCompressedArrayTexture?(C.setTexture2DArray(F,0),ze=z.TEXTURE_2D_ARRAY):(C.setTexture2D(F,0),ze=z.TEXTURE_2D),z.pixelStorei(z.UNPACK_FLIP_Y_WEBGL,F.flipY),z.pixelStorei(z.UNPACK_PREMULTIPLY_ALPHA_WEBGL,F.premultiplyAlpha),z.pixelStorei(z.UNPACK_ALIGNMENT,F.unpackAlignment);const Ot=z.getParameter(z.UNPACK_ROW_LENGTH),ft=z.getParameter(z.UNPACK_IMAGE_HEIGHT),En=z.getParameter(z.UNPACK_SKIP_PIXELS),ci=z.getParameter(z.UNPACK_SKIP_ROWS),hn=z.getParameter(z.UNPACK_SKIP_IMAGES);z.pixelStorei(z.UNPACK_ROW_LENGTH,wt.width),z.pixelStorei(z.UNPACK_IMAGE_HEIGHT,wt.height),z.pixelStorei(z.UNPACK_SKIP_PIXELS,Ie),z.pixelStorei(z.UNPACK_SKIP_ROWS,$e),z.pixelStorei(z.UNPACK_SKIP_IMAGES,qe);const cs=b.isDataArrayTexture||b.isData3DTexture,Rt=F.isDataArrayTexture||F.isData3DTexture;if(b.isRenderTargetTexture||b.isDepthTexture){const Bn=De.get(b),zi=De.get(F),gn=De.get(Bn.__renderTarget),ui=De.get(zi.__renderTarget);We.bindFramebuffer(z.READ_FRAMEBUFFER,gn.__webglFramebuffer),We.bindFramebuffer(z.DRAW_FRAMEBUFFER,ui.__webglFramebuffer);for(let Yn=0;Yn<ke;Yn++)cs&&z.framebufferTextureLayer(z.READ_FRAMEBUFFER,z.COLOR_ATTACHMENT0,De.get(b).__webglTexture,H,qe+Yn),b.isDepthTexture?(Rt&&z.framebufferTextureLayer(z.DRAW_FRAMEBUFFER,z.COLOR_ATTACHMENT0,De.get(F).__webglTexture,H,bt+Yn),z.blitFramebuffer(Ie,$e,de,Ee,Ue,rt,de,Ee,z.DEPTH_BUFFER_BIT,z.NEAREST)):Rt?z.copyTexSubImage3D(ze,H,Ue,rt,bt+Yn,Ie,$e,de,Ee):z.copyTexSubImage2D(ze,H,Ue,rt,bt+Yn,Ie,$e,de,Ee);We.bindFramebuffer(z.READ_FRAMEBUFFER,null),We.bindFramebuffer(z.DRAW_FRAMEBUFFER,null)}else Rt?b.isDataTexture||b.isData3DTexture?z.texSubImage3D(ze,H,Ue,rt,bt,de,Ee,ke,nn,ut,wt.data):F.isCompressedArrayTexture?z.compressedTexSubImage3D(ze,H,Ue,rt,bt,de,Ee,ke,nn,wt.data):z.texSubImage3D(ze,H,Ue,rt,bt,de,Ee,ke,nn,ut,wt):b.isDataTexture?z.texSubImage2D(z.TEXTURE_2D,H,Ue,rt,de,Ee,nn,ut,wt.data):b.isCompressedTexture?z.compressedTexSubImage2D(z.TEXTURE_2D,H,Ue,rt,wt.width,wt.height,nn,wt.data):z.texSubImage2D(z.TEXTURE_2D,H,Ue,rt,de,Ee,nn,ut,wt);z.pixelStorei(z.UNPACK_ROW_LENGTH,Ot),z.pixelStorei(z.UNPACK_IMAGE_HEIGHT,ft),z.pixelStorei(z.UNPACK_SKIP_PIXELS,En),z.pixelStorei(z.UNPACK_SKIP_ROWS,ci),z.pixelStorei(z.UNPACK_SKIP_IMAGES,hn),H===0&&F.generateMipmaps&&z.generateMipmap(ze),We.unbindTexture()},this.copyTextureToTexture3D=function(b,F,$=null,q=null,H=0){return b.isTexture!==!0&&(ro("WebGLRenderer: copyTextureToTexture3D function signature has changed."),$=arguments[0]||null,q=arguments[1]||null,b=arguments[2],F=arguments[3],H=arguments[4]||0),ro('WebGLRenderer: copyTextureToTexture3D function has been deprecated. Use "copyTextureToTexture" instead.'),this.copyTextureToTexture(b,F,$,q,H)},this.initRenderTarget=function(b){De.get(b).__webglFramebuffer===void 0&&C.setupRenderTarget(b)},this.initTexture=function(b){b.isCubeTexture?C.setTextureCube(b,0):b.isData3DTexture?C.setTexture3D(b,0):b.isDataArrayTexture||b.isCompressedArrayTexture?C.setTexture2DArray(b,0):C.setTexture2D(b,0),We.unbindTexture()},this.resetState=function(){L=0,D=0,N=null,We.reset(),dt.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return Ui}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(e){this._outputColorSpace=e;const t=this.getContext();t.drawingBufferColorspace=pt._getDrawingBufferColorSpace(e),t.unpackColorSpace=pt._getUnpackColorSpace()}}class yu{constructor(e,t=1,n=1e3){this.isFog=!0,this.name="",this.color=new at(e),this.near=t,this.far=n}clone(){return new yu(this.color,this.near,this.far)}toJSON(){return{type:"Fog",name:this.name,color:this.color.getHex(),near:this.near,far:this.far}}}class gR extends Jt{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new Si,this.environmentIntensity=1,this.environmentRotation=new Si,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(e,t){return super.copy(e,t),e.background!==null&&(this.background=e.background.clone()),e.environment!==null&&(this.environment=e.environment.clone()),e.fog!==null&&(this.fog=e.fog.clone()),this.backgroundBlurriness=e.backgroundBlurriness,this.backgroundIntensity=e.backgroundIntensity,this.backgroundRotation.copy(e.backgroundRotation),this.environmentIntensity=e.environmentIntensity,this.environmentRotation.copy(e.environmentRotation),e.overrideMaterial!==null&&(this.overrideMaterial=e.overrideMaterial.clone()),this.matrixAutoUpdate=e.matrixAutoUpdate,this}toJSON(e){const t=super.toJSON(e);return this.fog!==null&&(t.object.fog=this.fog.toJSON()),this.backgroundBlurriness>0&&(t.object.backgroundBlurriness=this.backgroundBlurriness),this.backgroundIntensity!==1&&(t.object.backgroundIntensity=this.backgroundIntensity),t.object.backgroundRotation=this.backgroundRotation.toArray(),this.environmentIntensity!==1&&(t.object.environmentIntensity=this.environmentIntensity),t.object.environmentRotation=this.environmentRotation.toArray(),t}}class Cp extends Or{static get type(){return"LineBasicMaterial"}constructor(e){super(),this.isLineBasicMaterial=!0,this.color=new at(16777215),this.map=null,this.linewidth=1,this.linecap="round",this.linejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.linewidth=e.linewidth,this.linecap=e.linecap,this.linejoin=e.linejoin,this.fog=e.fog,this}}const Ea=new Y,wa=new Y,Bd=new Bt,Qr=new _u,ia=new za,kl=new Y,zd=new Y;class _R extends Jt{constructor(e=new yi,t=new Cp){super(),this.isLine=!0,this.type="Line",this.geometry=e,this.material=t,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}computeLineDistances(){const e=this.geometry;if(e.index===null){const t=e.attributes.position,n=[0];for(let s=1,r=t.count;s<r;s++)Ea.fromBufferAttribute(t,s-1),wa.fromBufferAttribute(t,s),n[s]=n[s-1],n[s]+=Ea.distanceTo(wa);e.setAttribute("lineDistance",new qn(n,1))}else console.warn("THREE.Line.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}raycast(e,t){const n=this.geometry,s=this.matrixWorld,r=e.params.Line.threshold,o=n.drawRange;if(n.boundingSphere===null&&n.computeBoundingSphere(),ia.copy(n.boundingSphere),ia.applyMatrix4(s),ia.radius+=r,e.ray.intersectsSphere(ia)===!1)return;Bd.copy(s).invert(),Qr.copy(e.ray).applyMatrix4(Bd);const a=r/((this.scale.x+this.scale.y+this.scale.z)/3),l=a*a,c=this.isLineSegments?2:1,u=n.index,d=n.attributes.position;if(u!==null){const m=Math.max(0,o.start),_=Math.min(u.count,o.start+o.count);for(let v=m,p=_-1;v<p;v+=c){const f=u.getX(v),E=u.getX(v+1),T=sa(this,e,Qr,l,f,E);T&&t.push(T)}if(this.isLineLoop){const v=u.getX(_-1),p=u.getX(m),f=sa(this,e,Qr,l,v,p);f&&t.push(f)}}else{const m=Math.max(0,o.start),_=Math.min(d.count,o.start+o.count);for(let v=m,p=_-1;v<p;v+=c){const f=sa(this,e,Qr,l,v,v+1);f&&t.push(f)}if(this.isLineLoop){const v=sa(this,e,Qr,l,_-1,m);v&&t.push(v)}}}updateMorphTargets(){const t=this.geometry.morphAttributes,n=Object.keys(t);if(n.length>0){const s=t[n[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){const a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}}function sa(i,e,t,n,s,r){const o=i.geometry.attributes.position;if(Ea.fromBufferAttribute(o,s),wa.fromBufferAttribute(o,r),t.distanceSqToSegment(Ea,wa,kl,zd)>n)return;kl.applyMatrix4(i.matrixWorld);const l=e.ray.origin.distanceTo(kl);if(!(l<e.near||l>e.far))return{distance:l,point:zd.clone().applyMatrix4(i.matrixWorld),index:s,face:null,faceIndex:null,barycoord:null,object:i}}class vR extends yn{constructor(e,t,n,s,r,o,a,l,c){super(e,t,n,s,r,o,a,l,c),this.isCanvasTexture=!0,this.needsUpdate=!0}}class mo extends yi{constructor(e=1,t=1,n=1,s=32,r=1,o=!1,a=0,l=Math.PI*2){super(),this.type="CylinderGeometry",this.parameters={radiusTop:e,radiusBottom:t,height:n,radialSegments:s,heightSegments:r,openEnded:o,thetaStart:a,thetaLength:l};const c=this;s=Math.floor(s),r=Math.floor(r);const u=[],h=[],d=[],m=[];let _=0;const v=[],p=n/2;let f=0;E(),o===!1&&(e>0&&T(!0),t>0&&T(!1)),this.setIndex(u),this.setAttribute("position",new qn(h,3)),this.setAttribute("normal",new qn(d,3)),this.setAttribute("uv",new qn(m,2));function E(){const M=new Y,k=new Y;let L=0;const D=(t-e)/n;for(let N=0;N<=r;N++){const w=[],y=N/r,R=y*(t-e)+e;for(let V=0;V<=s;V++){const U=V/s,K=U*l+a,X=Math.sin(K),Q=Math.cos(K);k.x=R*X,k.y=-y*n+p,k.z=R*Q,h.push(k.x,k.y,k.z),M.set(X,D,Q).normalize(),d.push(M.x,M.y,M.z),m.push(U,1-y),w.push(_++)}v.push(w)}for(let N=0;N<s;N++)for(let w=0;w<r;w++){const y=v[w][N],R=v[w+1][N],V=v[w+1][N+1],U=v[w][N+1];(e>0||w!==0)&&(u.push(y,R,U),L+=3),(t>0||w!==r-1)&&(u.push(R,V,U),L+=3)}c.addGroup(f,L,0),f+=L}function T(M){const k=_,L=new mt,D=new Y;let N=0;const w=M===!0?e:t,y=M===!0?1:-1;for(let V=1;V<=s;V++)h.push(0,p*y,0),d.push(0,y,0),m.push(.5,.5),_++;const R=_;for(let V=0;V<=s;V++){const K=V/s*l+a,X=Math.cos(K),Q=Math.sin(K);D.x=w*Q,D.y=p*y,D.z=w*X,h.push(D.x,D.y,D.z),d.push(0,y,0),L.x=X*.5+.5,L.y=Q*.5*y+.5,m.push(L.x,L.y),_++}for(let V=0;V<s;V++){const U=k+V,K=R+V;M===!0?u.push(K,K+1,U):u.push(K+1,K,U),N+=3}c.addGroup(f,N,M===!0?1:2),f+=N}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new mo(e.radiusTop,e.radiusBottom,e.height,e.radialSegments,e.heightSegments,e.openEnded,e.thetaStart,e.thetaLength)}}class Pp extends Or{static get type(){return"MeshStandardMaterial"}constructor(e){super(),this.isMeshStandardMaterial=!0,this.defines={STANDARD:""},this.color=new at(16777215),this.roughness=1,this.metalness=0,this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.emissive=new at(0),this.emissiveIntensity=1,this.emissiveMap=null,this.bumpMap=null,this.bumpScale=1,this.normalMap=null,this.normalMapType=hp,this.normalScale=new mt(1,1),this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.roughnessMap=null,this.metalnessMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Si,this.envMapIntensity=1,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.flatShading=!1,this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.defines={STANDARD:""},this.color.copy(e.color),this.roughness=e.roughness,this.metalness=e.metalness,this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.emissive.copy(e.emissive),this.emissiveMap=e.emissiveMap,this.emissiveIntensity=e.emissiveIntensity,this.bumpMap=e.bumpMap,this.bumpScale=e.bumpScale,this.normalMap=e.normalMap,this.normalMapType=e.normalMapType,this.normalScale.copy(e.normalScale),this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.roughnessMap=e.roughnessMap,this.metalnessMap=e.metalnessMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.envMapIntensity=e.envMapIntensity,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.flatShading=e.flatShading,this.fog=e.fog,this}}class bu extends Jt{constructor(e,t=1){super(),this.isLight=!0,this.type="Light",this.color=new at(e),this.intensity=t}dispose(){}copy(e,t){return super.copy(e,t),this.color.copy(e.color),this.intensity=e.intensity,this}toJSON(e){const t=super.toJSON(e);return t.object.color=this.color.getHex(),t.object.intensity=this.intensity,this.groundColor!==void 0&&(t.object.groundColor=this.groundColor.getHex()),this.distance!==void 0&&(t.object.distance=this.distance),this.angle!==void 0&&(t.object.angle=this.angle),this.decay!==void 0&&(t.object.decay=this.decay),this.penumbra!==void 0&&(t.object.penumbra=this.penumbra),this.shadow!==void 0&&(t.object.shadow=this.shadow.toJSON()),this.target!==void 0&&(t.object.target=this.target.uuid),t}}class xR extends bu{constructor(e,t,n){super(e,n),this.isHemisphereLight=!0,this.type="HemisphereLight",this.position.copy(Jt.DEFAULT_UP),this.updateMatrix(),this.groundColor=new at(t)}copy(e,t){return super.copy(e,t),this.groundColor.copy(e.groundColor),this}}const Bl=new Bt,Hd=new Y,Vd=new Y;class MR{constructor(e){this.camera=e,this.intensity=1,this.bias=0,this.normalBias=0,this.radius=1,this.blurSamples=8,this.mapSize=new mt(512,512),this.map=null,this.mapPass=null,this.matrix=new Bt,this.autoUpdate=!0,this.needsUpdate=!1,this._frustum=new Mu,this._frameExtents=new mt(1,1),this._viewportCount=1,this._viewports=[new Gt(0,0,1,1)]}getViewportCount(){return this._viewportCount}getFrustum(){return this._frustum}updateMatrices(e){const t=this.camera,n=this.matrix;Hd.setFromMatrixPosition(e.matrixWorld),t.position.copy(Hd),Vd.setFromMatrixPosition(e.target.matrixWorld),t.lookAt(Vd),t.updateMatrixWorld(),Bl.multiplyMatrices(t.projectionMatrix,t.matrixWorldInverse),this._frustum.setFromProjectionMatrix(Bl),n.set(.5,0,0,.5,0,.5,0,.5,0,0,.5,.5,0,0,0,1),n.multiply(Bl)}getViewport(e){return this._viewports[e]}getFrameExtents(){return this._frameExtents}dispose(){this.map&&this.map.dispose(),this.mapPass&&this.mapPass.dispose()}copy(e){return this.camera=e.camera.clone(),this.intensity=e.intensity,this.bias=e.bias,this.radius=e.radius,this.mapSize.copy(e.mapSize),this}clone(){return new this.constructor().copy(this)}toJSON(){const e={};return this.intensity!==1&&(e.intensity=this.intensity),this.bias!==0&&(e.bias=this.bias),this.normalBias!==0&&(e.normalBias=this.normalBias),this.radius!==1&&(e.radius=this.radius),(this.mapSize.x!==512||this.mapSize.y!==512)&&(e.mapSize=this.mapSize.toArray()),e.camera=this.camera.toJSON(!1).object,delete e.camera.matrix,e}}class SR extends MR{constructor(){super(new bp(-5,5,5,-5,.5,500)),this.isDirectionalLightShadow=!0}}class yR extends bu{constructor(e,t){super(e,t),this.isDirectionalLight=!0,this.type="DirectionalLight",this.position.copy(Jt.DEFAULT_UP),this.updateMatrix(),this.target=new Jt,this.shadow=new SR}dispose(){this.shadow.dispose()}copy(e){return super.copy(e),this.target=e.target.clone(),this.shadow=e.shadow.clone(),this}}class bR extends bu{constructor(e,t){super(e,t),this.isAmbientLight=!0,this.type="AmbientLight"}}const Gd=new Bt;class ER{constructor(e,t,n=0,s=1/0){this.ray=new _u(e,t),this.near=n,this.far=s,this.camera=null,this.layers=new vu,this.params={Mesh:{},Line:{threshold:1},LOD:{},Points:{threshold:1},Sprite:{}}}set(e,t){this.ray.set(e,t)}setFromCamera(e,t){t.isPerspectiveCamera?(this.ray.origin.setFromMatrixPosition(t.matrixWorld),this.ray.direction.set(e.x,e.y,.5).unproject(t).sub(this.ray.origin).normalize(),this.camera=t):t.isOrthographicCamera?(this.ray.origin.set(e.x,e.y,(t.near+t.far)/(t.near-t.far)).unproject(t),this.ray.direction.set(0,0,-1).transformDirection(t.matrixWorld),this.camera=t):console.error("THREE.Raycaster: Unsupported camera type: "+t.type)}setFromXRController(e){return Gd.identity().extractRotation(e.matrixWorld),this.ray.origin.setFromMatrixPosition(e.matrixWorld),this.ray.direction.set(0,0,-1).applyMatrix4(Gd),this}intersectObject(e,t=!0,n=[]){return Vc(e,this,n,t),n.sort(Wd),n}intersectObjects(e,t=!0,n=[]){for(let s=0,r=e.length;s<r;s++)Vc(e[s],this,n,t);return n.sort(Wd),n}}function Wd(i,e){return i.distance-e.distance}function Vc(i,e,t,n){let s=!0;if(i.layers.test(e.layers)&&i.raycast(e,t)===!1&&(s=!1),s===!0&&n===!0){const r=i.children;for(let o=0,a=r.length;o<a;o++)Vc(r[o],e,t,!0)}}const $d=new Y;let ra,zl;class wR extends Jt{constructor(e=new Y(0,0,1),t=new Y(0,0,0),n=1,s=16776960,r=n*.2,o=r*.2){super(),this.type="ArrowHelper",ra===void 0&&(ra=new yi,ra.setAttribute("position",new qn([0,0,0,0,1,0],3)),zl=new mo(0,.5,1,5,1),zl.translate(0,-.5,0)),this.position.copy(t),this.line=new _R(ra,new Cp({color:s,toneMapped:!1})),this.line.matrixAutoUpdate=!1,this.add(this.line),this.cone=new pn(zl,new xu({color:s,toneMapped:!1})),this.cone.matrixAutoUpdate=!1,this.add(this.cone),this.setDirection(e),this.setLength(n,r,o)}setDirection(e){if(e.y>.99999)this.quaternion.set(0,0,0,1);else if(e.y<-.99999)this.quaternion.set(1,0,0,0);else{$d.set(e.z,0,-e.x).normalize();const t=Math.acos(e.y);this.quaternion.setFromAxisAngle($d,t)}}setLength(e,t=e*.2,n=t*.2){this.line.scale.set(1,Math.max(1e-4,e-t),1),this.line.updateMatrix(),this.cone.scale.set(n,t,n),this.cone.position.y=e,this.cone.updateMatrix()}setColor(e){this.line.material.color.set(e),this.cone.material.color.set(e)}copy(e){return super.copy(e,!1),this.line.copy(e.line),this.cone.copy(e.cone),this}dispose(){this.line.geometry.dispose(),this.line.material.dispose(),this.cone.geometry.dispose(),this.cone.material.dispose()}}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:uu}}));typeof window<"u"&&(window.__THREE__?console.warn("WARNING: Multiple instances of Three.js being imported."):window.__THREE__=uu);function TR(i,e){return-i*e*1.55}const AR=.3,Xd=.8;function Lp(i){return i.body_height+2*i.wheel_radius}function Dp(i,e){const t=i/Lp(e)*AR*e.weight;return Math.max(-Xd*e.weight,Math.min(Xd*e.weight,t))}const RR=120,dr=.1,Ta=60;class CR{constructor(e,t){this.look=e;const n=(s,r=.7,o=0)=>{const a=new Pp({color:s,roughness:r,metalness:o});return t&&(a.color.set(t),a.transparent=!0,a.opacity=.3),a};this.build(n,t===null),this.root.add(this.body,...this.wheels),this.body.position.y=e.wheel_radius,this.root.traverse(s=>{s instanceof pn&&(s.castShadow=t===null,s.receiveShadow=t===null)})}root=new ts;body=new ts;wheels=[new ts,new ts];x=0;z=0;last=null;build(e,t){const{wheel_radius:n,track:s,body_height:r,body_depth:o}=this.look,a=Math.max(s*.62,.02),l=n*.25,c=(h,d,m,_,v,p,f)=>{const E=new pn(new Os(m,d,h),_);E.position.set(v,p,f),this.body.add(E)},u=e("#e9ebee",.55);if(c(a,r*.94,o,u,0,l+r*.5,0),t){c(s*.8,n*.5,o*.55,e("#3b424a",.6),0,0,0),c(a*.72,r*.26,o*.04,e("#20262c",.25),o*.5,l+r*.72,0),c(a*.62,r*.18,o*.05,e("#b9d8c4",.3),o*.505,l+r*.73,0),c(a*.16,r*.08,o*.08,e("#e07a1f",.5),o*.5,l+r*.42,0);for(const h of[-1,1])c(a*.14,r*.06,o*.07,e("#8b949d",.5),o*.5,l+r*.42,h*a*.22);c(a*1.02,r*.05,o*1.03,e("#0072b2",.5),0,l+r*.12,0)}if(this.look.payload>0&&t){const h=Math.cbrt(this.look.payload/2500);c(h,h,h,e("#8c5a2b",.8),0,this.look.payload_height,0)}this.wheels.forEach((h,d)=>this.tyre(h,d===0?-s/2:s/2,e,t))}tyre(e,t,n,s){const r=this.look.wheel_radius,o=Math.min(this.look.track*.16,r*.7),a=new pn(new mo(r,r,o,40),n("#23272c",.95)),l=new pn(new mo(r*.66,r*.66,o*1.04,32),n("#c9ced3",.45,.1));a.rotation.x=l.rotation.x=Math.PI/2,e.add(a),s&&e.add(l);for(let c=0;s&&c<3;c+=1){const u=new pn(new Os(r*1.2,r*.13,o*1.1),n("#5c656e",.6));u.rotation.z=c*Math.PI/3,e.add(u)}e.position.set(0,r,t)}move(e,t){const{wheel_radius:n,track:s}=this.look,[r,,o,,a]=e;if(this.last!==null){const c=n*(o-this.last);this.x+=c*Math.cos(a),this.z-=c*Math.sin(a)}this.last=o,this.root.rotation.y=a,this.root.position.set(this.x+t*Math.sin(a),0,this.z+t*Math.cos(a)),this.body.rotation.z=-r;const l=s/(2*n)*a;this.wheels[0].rotation.z=-(o-l),this.wheels[1].rotation.z=-(o+l)}shift(e,t){this.x+=e,this.z+=t}start(e){e&&([this.x,this.z,this.last]=[e.x,e.z,e.last])}}function PR(i){const e=document.createElement("canvas");e.width=e.height=128;const t=e.getContext("2d");t.fillStyle=i?"#252b32":"#eeeeec",t.fillRect(0,0,128,128),t.strokeStyle=i?"#39424b":"#cfd1d2",t.lineWidth=2,t.strokeRect(0,0,128,128);const n=new vR(e);return n.wrapS=n.wrapT=Sa,n.repeat.set(Ta,Ta),n.anisotropy=8,n.colorSpace=Un,n}class LR{constructor(e,t){this.canvas=e,this.push=t,this.element=e,this.renderer=new mR({canvas:e,antialias:!0}),this.renderer.shadowMap.enabled=!0,this.renderer.shadowMap.type=Jf,this.floor=new pn(new yo(Ta*dr,Ta*dr),new Pp({roughness:.95})),this.floor.rotation.x=-Math.PI/2,this.floor.receiveShadow=!0,this.sun.castShadow=!0,this.sun.shadow.mapSize.set(1024,1024),this.sun.shadow.radius=6,this.sun.shadow.bias=-5e-4,this.arrow.visible=!1,this.scene.add(this.floor,this.sky,this.sun,this.sun.target,new bR("#ffffff",.35),this.arrow),this.paint(),this.listen()}renderer;scene=new gR;camera=new Xn(32,1,.02,30);sun=new yR("#fffdf8",2.4);sky=new xR("#ffffff","#c4c6c8",1.1);floor;figures=[];bodies=[];look=null;arrow=new wR(new Y(1,0,0),new Y,.1,13208064,.03,.02);eye={azimuth:.5,height:.26,away:1};grip=null;turning=null;centre=new Y;calm=matchMedia("(prefers-reduced-motion: reduce)");slow=0;detail=1;seen=-1;stale=!0;element;paint(){const e=document.documentElement.dataset.theme==="dark",t=new at(e?"#1b2026":"#f4f3ef");this.scene.background=t,this.scene.fog=new yu(t,1.2*this.size()+1.2,3*this.size()+2.2),this.floor.material.map=PR(e),this.floor.material.needsUpdate=!0,this.sun.intensity=e?1.7:1.9,this.stale=!0,this.sky.intensity=e?.7:1;const[n,s]=[this.look,this.bodies];n&&this.furnish(n,s)}furnish(e,t){const n=new Map(this.bodies.map((a,l)=>[a,this.figures[l]]));for(const a of this.figures)this.scene.remove(a.root);const s=this.look===null;this.look=e,this.bodies=t,this.seen=-1,this.stale=!0,this.figures=t.map((a,l)=>new CR(e,l?Ps(a):null)),this.figures.forEach((a,l)=>a.start(n.get(t[l])));for(const a of this.figures)this.scene.add(a.root);const r=this.size(),o=r*2.2;Object.assign(this.sun.shadow.camera,{left:-o,right:o,top:o,bottom:-o,near:.01,far:r*12}),this.sun.shadow.camera.updateProjectionMatrix(),s&&this.paint()}size(){return this.look?Lp(this.look):.25}move(e){if(!this.look||e.x.length!==this.figures.length||e.n===this.seen)return;this.seen=e.n,this.stale=!0;const t=this.look.track;this.figures.forEach((s,r)=>s.move(e.x[r],TR(r,t)));const n=this.figures[0];if(Math.hypot(n.x,n.z)>3){const s=a=>-Math.round(a/dr)*dr,[r,o]=[s(n.x),s(n.z)];for(const a of this.figures)a.shift(r,o);this.centre.add(new Y(r,0,o))}this.show(e.f[0],e.f[1],e.x[0][0],e.x[0][4])}show(e,t,n,s){const r=this.look,o=this.figures[0].root.position;if(this.arrow.visible=Math.abs(e)>.005,!this.arrow.visible)return;const a=Math.min(.04+Math.abs(e)/r.weight*this.size()*1.2,this.size()*1.6),l=new Y(Math.cos(s),0,-Math.sin(s)).multiplyScalar(Math.sign(e)),c=t*Math.sin(n),u=new Y(o.x+c*Math.cos(s),r.wheel_radius+t*Math.cos(n),o.z-c*Math.sin(s)),h=r.body_depth/2+.004;this.arrow.position.copy(u).addScaledVector(l,-a-h),this.arrow.setDirection(l),this.arrow.setLength(a,a*.32,a*.2)}draw(e){const{clientWidth:t,clientHeight:n}=this.canvas;if(!t||!n)return;this.pace(e);const s=Math.min(devicePixelRatio,2)*this.detail,r=this.renderer.getDrawingBufferSize(new mt);(Math.abs(r.x-t*s)>1||Math.abs(r.y-n*s)>1)&&(this.renderer.setPixelRatio(s),this.renderer.setSize(t,n,!1),this.camera.aspect=t/n,this.camera.updateProjectionMatrix(),this.stale=!0),this.stale&&(this.stale=this.follow(e),this.pull(),this.renderer.render(this.scene,this.camera))}pace(e){this.slow=e>45?this.slow+1:Math.max(0,this.slow-.5),this.slow>40&&this.detail>.6&&(this.detail*=.75,this.slow=0)}follow(e){const t=this.figures[0],n=this.size();t&&this.centre.lerp(new Y(t.x,0,t.z),this.calm.matches?1:1-Math.exp(-e/RR));const s=this.camera.aspect<1?1.25:1,r=n*3.5*this.eye.away*s,{azimuth:o,height:a}=this.eye,l=r*Math.cos(a),c=new Y(this.centre.x,n*.42,this.centre.z);this.camera.position.set(c.x+l*Math.sin(o),c.y+r*Math.sin(a),c.z+l*Math.cos(o)),this.camera.lookAt(c),this.sun.position.set(this.centre.x-n*2,n*5,this.centre.z+n*2.4),this.sun.target.position.copy(this.centre);const u=h=>Math.round(h/dr)*dr;return this.floor.position.set(u(this.centre.x),0,u(this.centre.z)),t?Math.hypot(t.x-this.centre.x,t.z-this.centre.z)>.001:!1}picture(){return this.renderer.render(this.scene,this.camera),new Promise(e=>this.canvas.toBlob(e))}turn(e,t){this.stale=!0,this.eye.azimuth+=e,this.eye.height=Math.min(1.2,Math.max(.03,this.eye.height+t))}zoom(e){this.stale=!0,this.eye.away=Math.min(3,Math.max(.45,this.eye.away*e))}grasp(){const e=this.look;if(!e)return{x:0,y:0};const t=this.figures[0].body.localToWorld(new Y(0,e.body_height*.6,0)).project(this.camera);return{x:(t.x+1)/2*this.canvas.clientWidth,y:(1-t.y)/2*this.canvas.clientHeight}}pointer(e){const t=this.canvas.getBoundingClientRect();return new mt((e.clientX-t.left)/t.width*2-1,1-(e.clientY-t.top)/t.height*2)}ray(e){const t=new ER;return t.setFromCamera(e,this.camera),t}listen(){this.canvas.addEventListener("pointerdown",e=>this.down(e)),this.canvas.addEventListener("pointermove",e=>this.moved(e));for(const e of["pointerup","pointercancel","lostpointercapture"])this.canvas.addEventListener(e,()=>this.up());this.canvas.addEventListener("wheel",e=>{e.preventDefault(),this.zoom(Math.exp(e.deltaY/900))},{passive:!1})}down(e){if(!this.look||!this.figures.length)return;this.canvas.setPointerCapture(e.pointerId);const t=this.pointer(e),n=this.ray(t).intersectObject(this.figures[0].root,!0)[0];if(!n){this.turning={x:e.clientX,y:e.clientY};return}const s=this.figures[0].body.worldToLocal(n.point.clone());this.grip={at:s,mouse:t,height:Math.max(0,s.y)},this.pull(),this.canvas.classList.add("holding")}moved(e){this.turning&&(this.turn((this.turning.x-e.clientX)/160,(e.clientY-this.turning.y)/260),this.turning={x:e.clientX,y:e.clientY}),this.grip&&(this.grip.mouse=this.pointer(e),this.pull())}pull(){const[e,t]=[this.grip,this.look];if(!e||!t)return;const n=this.figures[0],s=n.body.localToWorld(e.at.clone()),r=this.camera.position.clone().sub(s).setY(0).normalize(),o=new Qi().setFromNormalAndCoplanarPoint(r,s),a=this.ray(e.mouse).ray.intersectPlane(o,new Y);if(!a)return;const l=n.root.rotation.y,c=a.sub(s).dot(new Y(Math.cos(l),0,-Math.sin(l)));this.push({force:Dp(c,t),height:e.height})}up(){this.turning=null,this.grip&&(this.grip=null,this.canvas.classList.remove("holding"),this.push({force:0,height:0}))}}const DR="http://www.w3.org/2000/svg",eo=170,NR=110;class IR{constructor(e){this.push=e,this.element.addEventListener("pointerdown",t=>this.down(t)),this.element.addEventListener("pointermove",t=>this.moved(t));for(const t of["pointerup","pointercancel"])this.element.addEventListener(t,()=>this.up())}element=Zi("svg",{viewBox:"-200 0 400 200",class:"room flat",role:"img",tabindex:"0"});sides=[];arrow=Zi("path",{class:"arrow"});look=null;grip=null;paint(){}furnish(e,t){this.look=e,this.element.replaceChildren(Zi("line",{x1:-200,x2:200,y1:eo,y2:eo,class:"ground"})),this.sides=t.map((n,s)=>this.side(e,n,s>0)).reverse();for(const n of this.sides)this.element.append(n.root);this.sides.reverse(),this.element.append(this.arrow)}scale(e){return NR/(e.body_height+e.wheel_radius)}side(e,t,n){const s=this.scale(e),[r,o,a]=[e.wheel_radius*s,e.body_height*s,e.body_depth*s],l=n?{fill:"none",stroke:Ps(t),"stroke-width":2,opacity:.7}:{},c=Zi("rect",{x:-a/2,y:-o-r*.25,width:a,height:o,rx:3,class:n?"":"shell",...l}),u=Zi("g");u.append(Zi("circle",{r,class:n?"":"tyre",...l}),Zi("path",{d:`M${-r*.6} 0H${r*.6}M0 ${-r*.6}V${r*.6}`,class:n?"":"spokes",...l}));const h=Zi("g");return h.append(c,u),{root:h,body:c,wheel:u}}move(e){const t=this.look;if(!t||e.x.length!==this.sides.length)return;const n=this.scale(t),s=180/Math.PI;this.sides.forEach((h,d)=>{const[m,,_]=e.x[d],v=(_-e.x[0][2])*t.wheel_radius*n;h.root.setAttribute("transform",`translate(${v} ${eo-t.wheel_radius*n})`),h.body.setAttribute("transform",`rotate(${m*s})`),h.wheel.setAttribute("transform",`rotate(${_*s})`)});const[r,o]=e.f,a=r/t.weight*150,[l,c]=[o*Math.sin(e.x[0][0])*n,eo-(t.wheel_radius+o*Math.cos(e.x[0][0]))*n],u=Math.sign(r)*7;this.arrow.setAttribute("d",Math.abs(r)>.005?`M${l-a-u} ${c}H${l}m${-u} -5L${l} ${c}l${-u} 5`:"")}draw(){}picture(){return Promise.resolve(new Blob([new XMLSerializer().serializeToString(this.element)],{type:"image/svg+xml"}))}turn(){}zoom(){}grasp(){const e=(this.sides[0]?.body??this.element).getBoundingClientRect(),t=this.element.getBoundingClientRect();return{x:e.x-t.x+e.width/2,y:e.y-t.y+e.height*.4}}down(e){const t=this.sides[0];if(!this.look||!t?.root.contains(e.target))return;this.element.setPointerCapture(e.pointerId);const n=this.element.getBoundingClientRect().height/200,s=this.element.getBoundingClientRect().y+(eo-this.look.wheel_radius*this.scale(this.look))*n;this.grip={x:e.clientX,height:Math.max(0,(s-e.clientY)/n/this.scale(this.look))},this.push({force:0,height:this.grip.height})}moved(e){if(!this.grip||!this.look)return;const t=this.scale(this.look)*this.element.getBoundingClientRect().height/200;this.push({force:Dp((e.clientX-this.grip.x)/t,this.look),height:this.grip.height})}up(){this.grip&&(this.grip=null,this.push({force:0,height:0}))}}function Zi(i,e={}){const t=document.createElementNS(DR,i);for(const[n,s]of Object.entries(e))s!==""&&t.setAttribute(n,String(s));return t}const qd=.25,Yd=1.5,UR=.12,FR=.15;class OR{held=new Set;last="";asked=0;padded=!1;constructor(){window.addEventListener("keydown",e=>this.down(e)),window.addEventListener("keyup",e=>this.up(e)),window.addEventListener("blur",()=>this.release())}down(e){const t=e.target;e.repeat||e.ctrlKey||e.metaKey||e.altKey||/^(INPUT|SELECT|TEXTAREA)$/.test(t.tagName)||t.getAttribute("role")==="tab"||t.closest("dialog")||/^(Arrow(Up|Down|Left|Right)|f|b)$/.test(e.key)&&(e.preventDefault(),this.held.add(e.key),this.push(),this.steer(...this.keys()))}up(e){this.held.delete(e.key)&&(this.push(),this.steer(...this.keys()))}release(){this.held.size&&(this.held.clear(),this.push(),this.steer(0,0))}keys(){const e=t=>this.held.has(t)?1:0;return[qd*(e("ArrowUp")-e("ArrowDown")),Yd*(e("ArrowLeft")-e("ArrowRight"))]}pushing=!1;push(){const e=(this.held.has("b")?1:0)-(this.held.has("f")?1:0);if(!e&&!this.pushing)return;this.pushing=e!==0;const t=te.changed?.look;te.send({kind:"Drag",force:e*UR*(t?.weight??6),height:t?.com_height??.07})}steer(e,t){const n=`${e.toFixed(2)} ${t.toFixed(2)}`;n!==this.last&&(this.last=n,te.send({kind:"Steer",speed:e,rate:t}))}tick(e){if(e-this.asked<60)return;this.asked=e;const t=navigator.getGamepads?.().find(s=>s?.connected);if(this.held.size||!t&&!this.padded)return;this.padded=!!t;const n=s=>{const r=t?.axes[s]??0;return Math.abs(r)<FR?0:-r};this.steer(qd*n(1),Yd*n(0))}}const kR=[.2,3/8,5/9,2/3],BR=(i,e)=>t=>{const n=4*i+t-4,s="*-04-39?2$%%$%%'$%''%'''%')(%'))%(++'(++'(+.'+-.',/3',33)-/5)-43).36)058*18<+37<+4:<,4:E,5<A-7>C/8@F/:EH/<EK0=FM1?IP2@KS3BNV4DPY5FS\\6HV_6IXb7K[e8N^i9Pam;Rdp<Tgt".charCodeAt(n)-35,r=n>8?s:1,o=e/r|0,a=e%r,l=r-a,c=n>8?o*kR[t]+(i>5)&-2:s,u=o-c;return{t:l*u+a*u+a,o:[[l,u],[a,u+1]],i:c}},jd={M:1},Bs=i=>new Uint8Array(i),ao=i=>{const e=new Error(`lean-qr error ${i}`);throw e.code=i,e},oa=i=>"0123456789ABCDEFGHIJKLMNOPQRSTUVWXYZ $%*+-./:".indexOf(i),Gc=i=>i.charCodeAt(0),Np=(...i)=>(e,t)=>i.forEach(n=>n(e,t)),Ip=i=>e=>{e.eci!==i&&(e.push(7,4),i<128?e.push(i,8):i<16384?e.push(32768|i,16):e.push(12582912|i,24),e.eci=i)},Eu=i=>(e,t)=>{e.push(4,4),e.push(i.length,8+8*(t>9)),i.forEach(n=>e.push(n,8))},Br=(i,e,t,n,s=(o,a)=>t(o.length,a),r=n?o=>Np(Ip(n),i(o)):i)=>(r.test=e,r.l=t,r.est=s,r.eci=n&&[n],r),Up=Br(i=>(e,t)=>{e.push(1,4),e.push(i.length,10+2*(t>26)+2*(t>9));let n=0;for(;n<i.length-2;n+=3)e.push(+i.slice(n,n+3),10);n<i.length-1?e.push(+i.slice(n),7):n<i.length&&e.push(+i[n],4)},i=>/[0-9]/.test(i),(i,e)=>14+2*(e>26)+2*(e>9)+10*i/3),Fp=Br(i=>(e,t)=>{e.push(2,4),e.push(i.length,9+2*(t>26)+2*(t>9));let n=0;for(;n<i.length-1;n+=2)e.push(45*oa(i[n])+oa(i[n+1]),11);n<i.length&&e.push(oa(i[n]),6)},i=>oa(i)>=0,(i,e)=>13+2*(e>26)+2*(e>9)+5.5*i),Lr=Br(i=>Eu([...i].map(Gc)),i=>Gc(i)<128,(i,e)=>12+8*(e>9)+8*i);Lr._=!0,Lr.u=!0;const wu=Br(Lr,i=>Gc(i)<256,Lr.l,3);wu._=!0;const Kd=new TextEncoder,Tu=Br(i=>Eu(Kd.encode(i)),()=>1,0,26,(i,e)=>12+8*(e>9)+8*Kd.encode(i).length);Tu._=!0;let Wc=()=>{const i=new Map,e=new TextDecoder("sjis"),t=Bs(2);for(let n=0;n<7973;++n)t[0]=n/192+129+64*(n>5951),t[1]=n%192+64,i.set(e.decode(t),n);return i.delete("�"),Wc=()=>i,i};const Au=Br(i=>(e,t)=>{e.push(8,4),e.push(i.length,8+2*(t>26)+2*(t>9));for(const n of i)e.push(Wc().get(n),13)},i=>Wc().has(i),(i,e)=>12+2*(e>26)+2*(e>9)+13*i);Au._=!0;const Op=[Up,Fp,Lr,wu,Au,Tu],zR={auto:(i,{modes:e=Op}={})=>(t,n)=>{const s=e.map((u,h)=>{const d=new Map,m=(_,v)=>(d.has(_)||d.set(_,v(_,n)),d.get(_));return{m:u,h:1<<h,C:u.est("",n),S:u.l?(_,v)=>m(v-_,u.l):(_,v)=>m(i.slice(_,v),u.est)}});let r=[{v:0}],o=0,a=0,l=-1;for(const u of[...i,""]){let h=0;if(u)for(const d of s)d.m.test(u)&&(h|=d.h);if(!u||h!==l){if(l!==-1){const d=new Set(r.map(_=>_.D)),m=[];for(const{m:_,C:v,S:p,h:f}of s)if(l&f){const E=p(o,a);for(const T of _.eci??d)if(!_.u||!T){let M;for(const k of r)if(k.D===T||_.eci){const L=k.m===_&&k.D===T,D=L?k.V:k,N=_._&&L?k.v+E-v:D.v+12*(D.D!==T)+(L?p(L?k.$:o,a):E);(!M||N<M.v)&&(M={$:L?k.$:o,V:D,m:_,D:T,A:a,v:N})}M&&m.push(M)}}r=m}l=h,o=a}a+=u.length}r.length||ao(5);const c=[];for(let u=r.reduce((h,d)=>d.v<h.v?d:h);u.m;u=u.V)c.push(u.m(i.slice(u.$,u.A)));c.reverse().forEach(u=>u(t,n))},multi:Np,eci:Ip,bytes:Eu,numeric:Up,alphaNumeric:Fp,ascii:Lr,iso8859_1:wu,shift_jis:Au,utf8:Tu},HR=()=>({F:Bs(2956),I:0,push(i,e){for(let t=e,n=8-(7&this.I);t>0;t-=n,n=8)this.F[this.I>>3]|=i<<n>>t,this.I+=t<n?t:n}}),Hl=(i,e=i*i,t=Bs(e))=>({size:i,K:t,get:(n,s)=>n>=0&&n<i&&!!(1&t[s*i+n]),toString({on:n="##",off:s="  ",lf:r=`
`,pad:o=4,padX:a=o,padY:l=o}={}){let c="";for(let u=-l;u<i+l;++u){for(let h=-a;h<i+a;++h)c+=this.get(h,u)?n:s;c+=r}return c},toImageData(n,{on:s=[0,0,0],off:r=[0,0,0,0],pad:o=4,padX:a=o,padY:l=o}={}){const c=i+2*a,u=i+2*l,h=n.createImageData(c,u),d=new Uint32Array(h.data.buffer);h.data.set([...s,255]);const m=d[0];h.data.set([...r,255]);const _=d[0];for(let v=0;v<u;++v)for(let p=0;p<c;++p)d[v*c+p]=this.get(p-a,v-l)?m:_;return h},toCanvas(n,s){const r=n.getContext("2d"),o=this.toImageData(r,s);n.width=o.width,n.height=o.height,r.putImageData(o,0,0)},toDataURL({type:n="image/png",scale:s=1,...r}={}){const o=document.createElement("canvas"),a=o.getContext("2d"),l=this.toImageData(a,r);return o.width=l.width*s,o.height=l.height*s,a.putImageData(l,0,0),a.imageSmoothingEnabled=!1,a.globalCompositeOperation="copy",a.drawImage(o,0,0,l.width,l.height,0,0,o.width,o.height),o.toDataURL(n,1)}}),aa=[(i,e)=>1&(i^e),(i,e)=>1&e,i=>i%3,(i,e)=>(i+e)%3,(i,e)=>1&(i/3^e>>1),(i,e)=>(i&e&1)+i*e%3,(i,e)=>(i&e)+i*e%3&1,(i,e)=>(i^e)+i*e%3&1],Aa=Bs(511);for(let i=0,e=1;i<255;e=2*e^285*(e>127))Aa[Aa[e+255]=i++]=e;const kp=i=>Aa[i%255],Bp=i=>Aa[i+255],VR=(i,e)=>{const t=Bs(i.length+e.length-1);for(let n=0;n<i.length;++n)for(let s=0;s<e.length;++s)t[n+s]^=kp(i[n]+e[s]);return t.map(Bp)},GR=(i,e)=>{const t=Bs(i.length+e.length-1);t.set(i,0);for(let n=0;n<i.length;++n)if(t[n]){const s=Bp(t[n]);for(let r=0;r<e.length;++r)t[n+r]^=kp(e[r]+s)}return t.slice(i.length)},$c=[[0],[0,0]];for(let i=1;i<30;++i)$c.push(VR($c[i],[0,i]));const WR=(i,e)=>{const t=[[],[]];let n=0,s=0;for(const[o,a]of e.o)for(let l=0;l<o;++l,n+=a){const c=i.slice(n,n+a);t[0].push(c),t[1].push(GR(c,$c[e.i])),s+=a+e.i}const r=Bs(s);s=0;for(const o of t)for(let a=0,l=-1;l<s;++a){l=s;for(const c of o)a<c.length&&(r[s++]=c[a])}return r},zp=(i,e,t)=>{let n=i<<=t;for(let s=134217728;s>>=1;)n&s&&(n^=e*(s>>t));return n|i},$R=({size:i,K:e},t)=>{const n=(o,a,l,c)=>{for(;l-- >0;o+=i)e.fill(c,o,o+a)},s=(o,a,l)=>{for(let c=0;c++<3;l-=2)n(a*i+o-(l>>1)*(i+1),l,l,2|c)},r=2*((i-13)/(1+(t/7|0))/2+.75|0);if(t>1)for(let o=i-7;o>8;o-=r){for(let a=o;a>8;a-=r)s(o,a,5);o<i-7&&s(o,6,5)}if(t>6)for(let o=zp(t,7973,12),a=1;a<7;++a)for(let l=12;l-- >9;o>>=1)e[a*i-l]=2|1&o;n(7,2,9,2),n(i-8,8,9,2);for(let o=0;o<i;++o)e[6*i+o]=3^1&o;s(3,3,7),s(i-4,3,7);for(let o=0;o<i;++o)for(let a=o;a<i;++a)e[a*i+o]=e[o*i+a];e[(i-8)*i+8]=3},XR=({size:i,K:e})=>{const t=[];for(let n=i-2,s=i,r=-1;n>=0;n-=2){for(n===5&&(n=4);s+=r,s!==-1&&s!==i;){const o=s*i+n;e[o+1]||t.push(o+1),e[o]||t.push(o)}r*=-1}return t},qR=({K:i},e,t)=>e.forEach((n,s)=>i[n]=t[s>>3]>>(7&~s)&1),YR=({size:i,K:e},t,n,s)=>{for(let o=0;o<i;++o)for(let a=0;a<i;++a){const l=o*i+a;e[l]^=!(t(a,o)||2&e[l])}let r=21522^zp((1^s)<<3|n,1335,10);for(let o=0;o++<8;r>>=1)e[(o-(o<7))*i+8]=1&r,e[9*i-o]=1&r;for(let o=8;--o,r;r>>=1)e[8*i+o-(o<7)]=1&r,e[(i-o)*i+8]=1&r},jR=({size:i,K:e},t=0,n=0)=>{for(let s=0;s<i;++s){for(let r=0;r<2;++r)for(let o,a=0,l=0,c=2;a<i;++a){const u=1&e[r?s*i+a:a*i+s];n+=u,l=(l>>1|2098176)&(3047517^u-1),2049&l&&(t+=40),u^c&&(o=0),c=u,t+=++o===5?3:o>5}if(s)for(let r=i+s,o=5*e[s-1]^e[s];r<i*i;r+=i){const a=5*e[r-1]^e[r];t+=3*!(1&(o|a)|4&(o^a)),o=a}}return t+10*(10*Math.abs(n/(i*i)-1)|0)},Zd=[],Xc=(i=ao(1),{minCorrectionLevel:e=0,maxCorrectionLevel:t=3,minVersion:n=1,maxVersion:s=40,mask:r,trailer:o=60433,...a}={})=>{t<e&&ao(3),s<n&&ao(2),typeof i=="string"&&(i=zR.auto(i,a));for(let l=n,c=0;l<=s;++l){let u=Zd[l];u||(Zd[l]=u=Hl(4*l+17),$R(u,l),u.p=XR(u));const h=BR(l,u.p.length>>3);if(8*h(e).t<c)continue;const d=HR();i(d,l),c=d.I;for(let m=t;m>=e;--m){const _=h(m);if(8*_.t<c)continue;for(d.I=c+11&-8;d.I<8*_.t;)d.push(o,16);const v=Hl(u.size,u.K);return qR(v,u.p,WR(d.F,_)),(aa[r]?[aa[r]]:aa).map((p,f)=>{const E=Hl(v.size,v.K);return YR(E,p,r??f,m),E.s=aa[r]?0:jR(E),E}).reduce((p,f)=>f.s<p.s?f:p)}}ao(4)};Xc.with=(...i)=>(e,t)=>Xc(e,{modes:[...Op,...i],...t});const Vl="http://www.w3.org/2000/svg",to=4;function KR(i,e){const t=Xc(i,{minCorrectionLevel:jd.M,maxCorrectionLevel:jd.M}),n=document.createElementNS(Vl,"svg"),s=t.size+2*to;n.setAttribute("viewBox",`${-to} ${-to} ${s} ${s}`),n.setAttribute("class","qr"),n.setAttribute("role","img"),n.setAttribute("aria-label",e);const r=document.createElementNS(Vl,"rect");for(const[l,c]of Object.entries({x:-to,y:-to,width:s,height:s,fill:"#ffffff"}))r.setAttribute(l,String(c));const o=document.createElementNS(Vl,"path");let a="";for(let l=0;l<t.size;l+=1)for(let c=0;c<t.size;c+=1)t.get(c,l)&&(a+=`M${c} ${l}h1v1h-1z`);return o.setAttribute("d",a),o.setAttribute("fill","#000000"),o.setAttribute("shape-rendering","crispEdges"),n.append(r,o),n}const Jd="http://www.w3.org/2000/svg";class ZR{root=B("div",{className:"panel-body"});wall=B("div",{className:"wall"});scores=B("div",{className:"table"});build(){const e=B("div",{className:"column wide"});te.role==="teacher"&&e.append(B("div",{className:"row"},_t(W("broadcast"),()=>te.send({kind:"Broadcast",setup:te.setup}),{className:"main","data-key":"broadcast"}),_t(W("results"),()=>eC(QR()),{"data-key":"results"})),JR(),this.wall),e.append(this.scores),xt(this.root,e),this.update()}update(){const e=te.board?.students??[];xt(this.wall,...e.map(tC));const t=B("thead",{},B("tr",{},...["",W("name"),W("bestPush"),W("effort"),W("family")].map(s=>B("th",{scope:"col"},s)))),n=e.map((s,r)=>B("tr",{className:s.here?"":"away"},B("td",{},String(r+1)),B("td",{},s.name),B("td",{},uo(s.best,3)),B("td",{},uo(s.effort,0)),B("td",{},ai(s.controller).split(":")[0])));xt(this.scores,B("table",{className:"board","aria-label":W("board")},t,B("tbody",{},...n)))}}function JR(){const i=new URL(`#token=${te.invite}`,location.href.split("#")[0]).href;return B("figure",{className:"invite"},KR(i,W("invite")),B("figcaption",{},B("b",{},W("invite")),B("code",{},i)))}function QR(){const i=t=>`"${t.replace(/^[=+\-@\t]/,"'$&").replaceAll('"','""')}"`;return["place,name,best_push_Ns,effort_u2s,controller,here",...(te.board?.students??[]).map((t,n)=>[n+1,i(t.name),t.best.toFixed(4),t.effort.toFixed(1),i(t.controller),t.here].join(",")),""].join(`\r
`)}function eC(i){const e=URL.createObjectURL(new Blob(["\uFEFF",i],{type:"text/csv"}));B("a",{href:e,download:"results.csv"}).click(),window.setTimeout(()=>URL.revokeObjectURL(e),1e4)}function tC(i){const e=document.createElementNS(Jd,"svg");e.setAttribute("viewBox","-30 -48 60 60"),e.setAttribute("aria-hidden","true");const t=(s,r)=>{const o=document.createElementNS(Jd,s);for(const[a,l]of Object.entries(r))o.setAttribute(a,l);e.append(o)},n=(i.pitch*180/Math.PI).toFixed(1);return t("rect",{x:"-6",y:"-40",width:"12",height:"38",rx:"3",class:"stick",transform:`rotate(${n})`}),t("circle",{r:"8",cx:"0",cy:"0",class:"wheel"}),t("line",{x1:"-30",x2:"30",y1:"8.5",y2:"8.5",class:"ground"}),B("figure",{className:`tile${i.fallen?" down":""}${i.here?"":" away"}`},e,B("figcaption",{},i.name))}const xs=["twin","nonlinear","linear"],Gl=[{setup:{controller:"off",bodies:xs},lean:.02},{setup:{controller:"off",kit:"ideal",bodies:["nonlinear","linear"]},lean:.03},{setup:{controller:"lqr",bodies:xs},lean:.1},{setup:{controller:"lqg",bodies:xs},lean:0,strike:"front"},{setup:{controller:"lqg",bodies:xs},lean:0,strike:"back"},{setup:{controller:"lqg",bodies:xs},lean:0,strike:"front"},{setup:{controller:"lqr",bodies:xs,payload:.12,payload_height:.2},lean:0},{setup:{controller:"robust",bodies:xs,payload:.12,payload_height:.2},lean:0}];class nC{root=B("div",{className:"panel-body tour"});at=0;build(){const e=Hf().tour[this.at],t=(n,s)=>B("div",{className:"hint-part"},B("h4",{},n),B("p",{},s));xt(this.root,B("div",{className:"column wide"},B("p",{className:"note"},W("tourStep",{n:this.at+1})),B("h3",{},e.title),B("div",{className:"hints"},t(W("tourDo"),e.do),t(W("tourWatch"),e.watch),t(W("tourAsk"),e.ask)),B("div",{className:"row"},_t(W("previous"),()=>this.move(-1,"previous"),{disabled:this.at===0,"data-key":"tour-previous"}),_t(W("tourSet"),()=>this.set(),{className:"main","data-key":"tour-set"}),_t(W("next"),()=>this.move(1,"next"),{disabled:this.at===Gl.length-1,"data-key":"tour-next"}))))}move(e,t="set"){this.at=Math.min(Math.max(this.at+e,0),Gl.length-1),this.build();const n=s=>this.root.querySelector(`[data-key=tour-${s}]:enabled`);(n(t)??n("set"))?.focus()}set(){const{setup:e,lean:t,strike:n}=Gl[this.at];te.change({...Fa,...e}),te.send({kind:"Play",paused:!1,speed:1}),te.send({kind:"StandUp",pitch:t}),n&&window.setTimeout(()=>te.send({kind:"Strike",what:n,size:n==="front"?.1:-.12}),1e3)}}const Wl=["Controller","Robot","Kit","See","Identify","Keep","Tour","Class"];class iC{constructor(e){this.app=e,this.theme(localStorage.getItem("theme")??""),Nh(localStorage.getItem("language")??(navigator.language.startsWith("es")?"es":"en")),te.listen(t=>this.hear(t)),this.scrub.addEventListener("input",()=>te.send({kind:"Scrub",back:-Number(this.scrub.value)})),this.room.element.addEventListener("keydown",t=>this.look(t)),window.addEventListener("keydown",t=>this.key(t)),window.addEventListener("hashchange",()=>{const t=Yf(location.hash);t&&te.change(t)}),this.begin()}room=this.furnish();charts=new Yy(()=>this.seconds);see=new sb;controller=new ub;robot=new hb;kit=new db;identify=new pb;keep=new mb(()=>this.room.picture());tour=new nC;classes=new ZR;tab="Controller";seconds=10;knock=.05;speed=1;scrub=B("input",{type:"range",min:"-60",max:"0",step:"0.02",value:"0",className:"scrub","data-key":"scrub"});pauseButton=B("button",{type:"button","data-key":"pause"});status=B("span",{className:"status",role:"status"});light=B("span",{className:"headlight"});force=B("div",{className:"force","aria-hidden":"true"});fell=B("div",{className:"fell",role:"status"});toasts=B("div",{className:"toasts",role:"log","aria-live":"polite"});spoken=B("p",{className:"hidden","aria-live":"off"});tabs=B("div",{className:"tabs",role:"tablist"});panel=B("div",{className:"panel",role:"tabpanel",tabIndex:-1,id:"panel"});clock=B("span",{className:"clock"});state="connecting";drawn=0;drawnFirst=!1;plotted=0;said=0;shape="";steering=new OR;begin(){const e=zh.inPage(),t=Ky(location.hash)||(sessionStorage.getItem("token")??"");t&&sessionStorage.setItem("token",t),location.hash.includes("token=")&&history.replaceState(null,"",location.pathname),this.build(),e?(this.says("replaying"),new zh(e),document.body.classList.add("replay")):t&&!sessionStorage.getItem("name")&&t.length<12?this.join(t):this.connect(t,sessionStorage.getItem("name")??""),requestAnimationFrame(n=>this.frame(n))}connect(e,t){new Zy({token:e,name:t},(n,s)=>this.says(n,s))}join(e){const t=B("input",{type:"text",id:"name",maxLength:40,required:!0,autocomplete:"name"}),n=B("dialog",{className:"join","aria-label":W("joinTitle")},B("form",{method:"dialog",onsubmit:s=>{s.preventDefault(),t.value.trim()&&(sessionStorage.setItem("name",t.value.trim()),n.remove(),this.connect(e,t.value.trim()))}},B("h2",{},W("joinTitle")),B("label",{for:"name"},W("yourName")),t,B("button",{className:"main"},W("enter"))));this.app.append(n),n.showModal()}build(){this.room.element.setAttribute("aria-label",W("scene")),this.scrub.setAttribute("aria-label",W("back"));const e=Object.entries(va).map(([s,r])=>[s,r.language]),t=B("header",{},B("a",{className:"skip",href:"#panel",onclick:()=>this.panel.focus()},W("skip")),B("h1",{},B("span",{className:"mark","aria-hidden":"true"}),W("title")),this.light,B("span",{className:"grow"}),this.clock,this.status,Is("",e,zf(),s=>this.speak(s),"language"),_t("◐",()=>this.theme(document.documentElement.dataset.theme==="dark"?"light":"dark"),{"aria-label":W("theme"),title:W("theme"),"data-key":"theme"}),_t("?",()=>this.help(),{"aria-label":W("help"),title:W("help"),"data-key":"help"}));t.querySelector("select")?.setAttribute("aria-label","Language / Idioma");const n=B("section",{className:"scene","aria-label":W("scene")},this.room.element,this.force,this.fell,B("p",{className:"hint"},W("hint")),this.transport(),this.pushes());xt(this.app,t,B("main",{},n,this.charts.root,this.panels()),this.toasts,this.spoken),this.lamp(),te.changed&&this.rebuild()}furnish(){const e=Wf(33,s=>te.send({kind:"Drag",force:s.force,height:s.height})),t=B("canvas",{className:"room",tabIndex:0,role:"img"}),n=document.createElement("canvas").getContext("webgl2");return n?.getExtension("WEBGL_lose_context")?.loseContext(),n?new LR(t,e):new IR(e)}transport(){this.pauseButton.onclick=()=>this.pause();const e=[["0.05","1/20"],["0.1","1/10"],["0.25","1/4"],["0.5","1/2"],["1","1"]],t=Is(W("speed"),e,String(this.speed),s=>{this.speed=Number(s),te.send({kind:"Play",paused:te.snapshot?.paused??!1,speed:this.speed})},"speed"),n=_t(W("step"),()=>te.send({kind:"Step",periods:1}),{"data-key":"step"});return B("div",{className:"transport"},this.pauseButton,n,t,B("label",{className:"scrubbing"},B("span",{},W("back")),this.scrub))}pushes(){const e=(s,r)=>()=>te.send({kind:"Strike",what:s,size:r}),t=()=>te.changed?.look.weight??6,n=si(W("size"),{low:.01,high:.5,log:!0,show:s=>W("newtons",{force:uo(s,2)})+" s",key:"knock"},s=>this.knock=s);return n.set(this.knock),B("div",{className:"pushes",role:"group","aria-label":W("pushes")},_t(W("front"),e("front",.1),{title:W("frontTip"),"data-key":"front"}),_t(W("backPush"),e("back",-.12),{title:W("backTip"),"data-key":"back"}),_t(W("impulse"),()=>e("impulse",this.knock)(),{"data-key":"impulse"}),n.root,_t(W("pullLeft"),()=>e("pull_left",.25*t())(),{"data-key":"pull_left"}),_t(W("pullRight"),()=>e("pull_right",.25*t())(),{"data-key":"pull_right"}),_t(W("tilt"),()=>te.send({kind:"StandUp",pitch:.1}),{"data-key":"tilt"}),_t(W("standUp"),()=>this.stand(),{"data-key":"stand",className:"main"}))}panels(){const e=Wl.filter(n=>n!=="Class"||te.role!=="alone"),t={Controller:W("tabController"),Robot:W("tabRobot"),Kit:W("tabKit"),See:W("tabSee"),Identify:W("tabIdentify"),Keep:W("tabKeep"),Tour:W("tabTour"),Class:W("tabClass")};return this.tabs.setAttribute("aria-label",W("tabs")),xt(this.tabs,...e.map(n=>_t(t[n],()=>this.open(n),{role:"tab",id:`tab-${n}`,"aria-selected":String(n===this.tab),"aria-controls":"panel",tabIndex:n===this.tab?0:-1,"data-key":`tab-${n}`,onkeydown:s=>this.along(s,e,n)}))),B("section",{className:"below"},this.tabs,this.panel)}along(e,t,n){const s={ArrowRight:1,ArrowLeft:-1}[e.key];if(!s)return;e.preventDefault(),e.stopPropagation();const r=t[(t.indexOf(n)+s+t.length)%t.length];this.open(r),document.getElementById(`tab-${r}`)?.focus()}open(e){this.tab=e;for(const t of this.tabs.querySelectorAll("[role=tab]")){const n=t.id===`tab-${e}`;t.setAttribute("aria-selected",String(n)),t.tabIndex=n?0:-1}this.panel.setAttribute("aria-labelledby",`tab-${e}`),this.fill()}fill(){if(!te.catalogue||!te.changed)return;const e={Controller:this.controller,Robot:this.robot,Kit:this.kit,See:this.see,Identify:this.identify,Keep:this.keep,Tour:this.tour,Class:this.classes}[this.tab];e.build(),xt(this.panel,e.root)}rebuild(){this.shape="",this.follow(),this.fill(),this.lamp()}follow(){const e=te.changed;if(!e)return;const t=JSON.stringify([e.bodies,e.look]);t!==this.shape&&(this.shape=t,this.room.furnish(e.look,e.bodies),this.charts.build())}hear(e){switch(e.kind){case"Welcome":this.build();break;case"Catalogue":this.fill();break;case"Changed":{const t=!this.panel.firstChild;this.follow(),t?this.fill():this.update();break}case"Analysed":case"Light":this.lamp(),this.update();break;case"Equations":this.tab==="See"&&this.see.show();break;case"Snapshot":this.transported();break;case"Progress":this.identify.progress(e.job,e.fraction),e.job==="certify"&&this.busy(e.fraction<1);break;case"JobResult":this.identify.found(),this.toast(Fn(e.title),e.ok?"info":e.job==="certify"?"error":"warn"),Es&&this.tab==="Identify"&&this.identify.build();break;case"Made":this.keep.made(e.name,e.url.startsWith("blob:")?e.url:te.files+e.url),this.toast(W("made",{name:e.name}),"info");break;case"Notice":this.toast(e.key?ai(e.key):sC(e.text),e.level);break;case"Recovered":this.recovered(e.impulse,e.best,e.fell);break;case"Board":this.tab==="Class"&&this.classes.update();break}}update(){this.tab==="See"&&this.see.show(),{Controller:this.controller,Robot:this.robot,Kit:this.kit}[this.tab]?.update()}lamp(){const e=te.lit?.light??"none";xt(this.light,B("span",{className:`lamp ${e}`,"aria-hidden":"true"}),B("span",{},jf()[1].textContent??""))}busy(e){this.panel.querySelector("[data-key=certify]")?.toggleAttribute("aria-busy",e)}recovered(e,t,n){const s={impulse:e.toFixed(3),best:t.toFixed(3)};this.toast(W(n?"lostPush":"recovered",s),"info")}transported(){const e=te.snapshot;if(!e)return;const t=e.paused?W("play"):W("pause");this.pauseButton.textContent!==t&&(this.pauseButton.textContent=t),document.activeElement!==this.scrub&&(this.scrub.value=String(-e.back)),this.clock.textContent=`${uo(e.t,1)} s`;const n=!!e.x[0][8];n!==!!this.fell.textContent&&xt(this.fell,...n?[B("span",{},W("fallen")+" "),_t(W("standUp"),()=>this.stand(),{className:"main"})]:[]);const s=e.f[0];this.force.textContent=Math.abs(s)>.005?W("newtons",{force:uo(s,2)}):""}stand(){te.send({kind:"StandUp",pitch:0}),te.send({kind:"Play",paused:!1,speed:this.speed})}pause(){te.send({kind:"Play",paused:!te.snapshot?.paused,speed:this.speed})}says(e,t=""){this.state=e;const n={connecting:W("connecting"),connected:W("connected"),lost:W("lost"),refused:W("refused"),replaying:W("replaying")};this.status.className=`status ${e}`,this.status.textContent=n[e],e==="refused"&&(sessionStorage.removeItem("name"),xt(this.app,B("main",{className:"refused",role:"alert"},B("h1",{},W("refused")),B("p",{},Fn(t)),_t("↻",()=>location.reload()))))}toast(e,t){const n=B("div",{className:`toast ${t}`},B("span",{},e),_t("×",()=>n.remove(),{"aria-label":W("close")}));for(this.toasts.append(n);this.toasts.children.length>3;)this.toasts.firstElementChild?.remove();window.setTimeout(()=>n.remove(),t==="error"?15e3:6e3)}speak(e){Nh(e),localStorage.setItem("language",e),this.build(),this.says(this.state),this.fell.replaceChildren(),this.app.querySelector("[data-key=language]")?.focus()}theme(e){const t=e?e==="dark":matchMedia("(prefers-color-scheme: dark)").matches;document.documentElement.dataset.theme=t?"dark":"light",e&&localStorage.setItem("theme",e),this.room.paint(),te.changed&&this.charts.build(),this.panel.firstChild&&this.fill()}help(){const e=Hf().keys.map(([n,s])=>B("tr",{},B("th",{scope:"row"},n),B("td",{},s))),t=B("dialog",{className:"help","aria-label":W("help"),onclose:()=>t.remove()},B("h2",{},W("help")),B("table",{},B("tbody",{},...e)),_t(W("close"),()=>t.close(),{className:"main"}));this.app.append(t),t.showModal()}key(e){const t=e.target;if(!(e.ctrlKey||e.metaKey||e.altKey||/^(INPUT|SELECT|TEXTAREA|DIALOG)$/.test(t.tagName))&&!(e.key===" "&&t.tagName==="BUTTON")){if(e.key==="?")this.help();else if(e.key===" ")this.pause();else if(e.key===".")te.send({kind:"Step",periods:1});else if(e.key===","||e.key==="/")te.send({kind:"Scrub",back:Math.max(0,Math.min(60,(te.snapshot?.back??0)+(e.key===","?.25:-.25)))});else if(e.key==="s")this.stand();else if(e.key==="n"||e.key==="p")this.toured(e.key==="n"?1:-1);else if(e.key==="k")te.send({kind:"Strike",what:"impulse",size:this.knock});else if(/^[1-8]$/.test(e.key)&&document.getElementById(`tab-${Wl[Number(e.key)-1]}`))this.open(Wl[Number(e.key)-1]);else return;e.preventDefault()}}toured(e){const t=this.tab==="Tour";t||this.open("Tour"),this.tour.move(t?e:0)}look(e){const t={"[":[-.15,0],"]":[.15,0],"{":[0,-.1],"}":[0,.1]};e.key in t&&this.room.turn(...t[e.key]),e.key==="+"&&this.room.zoom(.9),e.key==="-"&&this.room.zoom(1.1)}frame(e){te.snapshot&&this.room.move(te.snapshot),this.room.draw(e-this.drawn),this.drawnFirst||=te.snapshot!==null,this.drawn=e,e-this.plotted>45&&(this.charts.draw(),this.tab==="See"&&this.see.draw(),this.plotted=e),e-this.said>2e3&&(this.describe(),this.said=e),this.steering.tick(e),requestAnimationFrame(t=>this.frame(t))}describe(){const[e,t]=[te.snapshot,te.changed];if(!e||!t)return;const n=ai(t.bodies[0]),s=(t.look.wheel_radius*e.x[0][2]*100).toFixed(0),r=e.x[0][8]?W("fellNow",{body:n}):W("sceneNow",{body:n,pitch:(e.x[0][0]*180/Math.PI).toFixed(1),way:s});this.spoken.textContent=r,this.room.element.setAttribute("aria-label",`${W("scene")} ${r}`)}picture(){return this.room.picture()}grasp(){return this.room.grasp()}}function sC(i){return Gf(i)?Fn(i):W("original",{text:i})}const rC=new iC(document.getElementById("app"));Object.assign(window,{upright:{store:te,page:rC}});
